// How far the kernels that a step spends its time in are from what the machine can do: their operations
// or bytes a second against those of a dense product and of a stream, compiled with the same flags.
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bench/bench.h"
#include "app/bench/paper_states.h"
#include "app/bench/step_problem.h"
#include "core/linear/block_lu.h"
#include "core/problem/by_body.h"
#include "core/problem/residual.h"
#include "core/world/neighbors.h"

namespace quicksand::bench {

namespace {

constexpr const char* kFlops = "GFlop/s";
constexpr const char* kBytes = "GB/s";
constexpr const char* kPeak = "dense product of 256 x 256 (Eigen)";
constexpr const char* kMemory = "triad of 3 x 64 MiB";
constexpr const char* kCache = "triad of 3 x 128 KiB";

// The shortest of the repeats: a limit, and what comes near it, is what nothing disturbed.
template <class Work>
Row measured(const Options& options, double amount, const char* unit, Work work) {
  constexpr double kShortest = 1e-2;  // a repeat lasts so long at least [s]
  Row row{.what = "kernel", .unit = unit};
  row.seconds.cpu = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < options.repeats_or(20); ++repeat) {
    int times = 0;
    const Stopwatch watch;
    Seconds spent;
    do {
      work();
      ++times;
      spent = watch.elapsed();
    } while (spent.cpu < kShortest);
    if (spent.cpu / times < row.seconds.cpu) row.seconds = {spent.cpu / times, spent.wall / times};
  }
  row.value = 1e-9 * amount / row.seconds.cpu;
  return row;
}

Row triad(const Options& options, std::size_t bytes_each) {
  const std::size_t n = bytes_each / sizeof(double);
  Eigen::ArrayXd a = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(n)), b = a + 1, c = a + 2;
  return measured(options, static_cast<double>(3 * bytes_each), kBytes,
                  [&] { a = b + a[0] * 1e-9 + 3.0 * c; });
}

Row dense_product(const Options& options) {
  constexpr int kSize = 256;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(kSize, kSize);
  Eigen::MatrixXd b = Eigen::MatrixXd::Identity(kSize, kSize), c = b;
  return measured(options, 2.0 * kSize * kSize * kSize, kFlops, [&] {
    c.noalias() = a * b;
    b(0, 0) = 1 + 1e-9 * c(0, 0);  // so that no product can be left out
  });
}

// Rows, edges and blocks of M + H^T D H; the values do not matter for the time.
struct Blocks {
  int rows = 0;
  std::vector<Edge> edges;

  // By parts of the factorisation.
  ByBody rows_of, edges_of;

  void analyse(BlockLu& lu) {
    lu.analyse(rows, edges);
    const auto parts = static_cast<std::size_t>(lu.parts());
    rows_of.fill(parts, [&](const auto& use) {
      for (int i = 0; i < rows; ++i) use(lu.part_of(lu.position(i)), i);
    });
    edges_of.fill(parts, [&](const auto& use) {
      int e = 0;
      for (const auto& [i, j] : edges)
        use(lu.part_of(std::min(lu.position(i), lu.position(j))), e++);
    });
  }
  void factorise(BlockLu& lu) const {
    lu.factorise([&](int part) {
      const auto k = static_cast<std::size_t>(part);
      for (const int i : rows_of.of(k)) lu.diagonal(i).entry() = 10 * Mat3::Identity();
      for (const int e : edges_of.of(k))
        lu.upper(e).entry() = lu.lower(e).entry() = Mat3::Constant(-0.1);
    });
  }
};

Blocks blocks_of(const ContactProblem& problem) {
  Blocks blocks;
  std::vector<int> row_of(problem.inverse_mass.size(), -1);
  for (std::size_t i = 0; i < row_of.size(); ++i)
    if (problem.inverse_mass[i].x() > 0) row_of[i] = blocks.rows++;
  for (const ContactRow& contact : problem.contacts)
    if (row_of[contact.a] >= 0 && row_of[contact.b] >= 0)
      blocks.edges.push_back({row_of[contact.a], row_of[contact.b]});
  return blocks;
}

// Of about so many disks, four contacts a disk: some more than a packing has when its bonds are lost.
Blocks square_lattice(int disks) {
  const int side = static_cast<int>(std::sqrt(disks));
  Blocks blocks;
  blocks.rows = side * side;
  for (int i = 0; i < blocks.rows; ++i) {
    if ((i + 1) % side != 0) blocks.edges.push_back({i, i + 1});
    if (i + side < blocks.rows) blocks.edges.push_back({i, i + side});
  }
  return blocks;
}

void measure_lu(Blocks blocks, const std::string& of, const Options& options,
                std::vector<Row>& rows) {
  BlockLu lu;
  blocks.analyse(lu);
  Row factors = measured(options, 0, kFlops, [&] { blocks.factorise(lu); });
  factors.name = "block LU" + of + ", fill and factorise";
  factors.value = 1e-9 * lu.operations() / factors.seconds.cpu;
  rows.push_back(factors);

  const Eigen::Vector4d start(1, 2, 3, 0);
  std::vector<Eigen::Vector4d> x(static_cast<std::size_t>(blocks.rows), start);
  const double read = sizeof(PaddedBlock) * (2.0 * static_cast<double>(lu.fill()) + blocks.rows);
  Row solution = measured(options, read, kBytes, [&] {
    lu.solve(x.data());
    std::ranges::fill(x, start);
  });
  solution.name = "block LU" + of + ", solve";
  rows.push_back(solution);
}

void measure_kernels(const Options& options, std::vector<Row>& rows) {
  const World world = fresh_deposit(options, options.quick ? 400 : 5000);
  const StepProblem step = next_problem(world, paper_scene(options).step);
  const auto bodies = static_cast<double>(step.problem.inverse_mass.size());
  const auto contacts = static_cast<double>(step.problem.contacts.size());
  measure_lu(blocks_of(step.problem), "", options, rows);

  // Rows and impulses, for the velocities and for the residual; three vectors a body.
  ContactState state{.velocity = {}, .impulse = step.start};
  Row evaluated = measured(
      options, 2 * contacts * (sizeof(ContactRow) + sizeof(Vec3)) + 3 * bodies * sizeof(Vec3),
      kBytes, [&] { residual(step.problem, state); });
  evaluated.name = "residual";
  rows.push_back(evaluated);

  // Positions and radii read, pairs written.
  constexpr double kReach = 0.1;  // [d]
  const auto pairs = static_cast<double>(pairs_within(world, kReach).size());
  Row searched = measured(options, bodies * (sizeof(Vec2) + sizeof(double)) + pairs * sizeof(Pair),
                          kBytes, [&] { pairs_within(world, kReach); });
  searched.name = "neighbour search, anew";
  rows.push_back(searched);
  for (Row& row : rows) {
    row.size = world.disks.size();
    row.contacts = static_cast<std::int64_t>(contacts);
  }

  const Blocks lattice = square_lattice(world.disks.size());
  const std::size_t first = rows.size();
  measure_lu(lattice, " of a square lattice", options, rows);
  for (Row& row : std::span(rows).subspan(first)) {
    row.size = lattice.rows;
    row.contacts = static_cast<std::int64_t>(lattice.edges.size());
  }
}

double rate_of(std::span<const Row> rows, const char* limit) {
  const auto found = std::ranges::find(rows, limit, &Row::name);
  return found == rows.end() ? 0 : found->value.value_or(0);
}

}  // namespace

std::vector<Task> kernel_tasks(const Options& options) {
  return {
      {kPeak, [options](std::vector<Row>& rows) { rows.push_back(dense_product(options)); }},
      {kMemory,
       [options](std::vector<Row>& rows) {
         rows.push_back(triad(options, std::size_t{64} << 20U));
       }},
      {kCache,
       [options](std::vector<Row>& rows) {
         rows.push_back(triad(options, std::size_t{128} << 10U));
       }},
      {"kernels of a step", [options](std::vector<Row>& rows) { measure_kernels(options, rows); }}};
}

void report_kernels(std::span<const Row> rows, const Options&, Section& section) {
  section.add(Paragraph{
      "The shortest of the repeats, one thread, on the first step of a deposit without dynamics "
      "and on a square lattice of as many disks. The limits are compiled with the program's own "
      "flags: no -march, so two doubles at a time and no fused multiply-add; the block LU takes "
      "four where the processor can. Bytes are those that must pass at least once."});
  Table table{.columns = {{"kernel"},
                          {"µs", true},
                          {"rate", true},
                          {"of the peak", true},
                          {"of the stream from memory", true},
                          {"from the cache", true}}};
  for (const Row& row : rows) {
    if (!row.value) continue;
    const auto share = [&](const char* limit, const char* unit) -> Cell {
      const double most = rate_of(rows, limit);
      if (row.unit != unit || most <= 0) return {"-"};
      return {format("%.0f %%", 100 * *row.value / most)};
    };
    table.rows.push_back({{row.name},
                          {format("%.3g", 1e6 * row.seconds.cpu)},
                          {format("%.3g %s", *row.value, row.unit.c_str())},
                          share(kPeak, kFlops),
                          share(kMemory, kBytes),
                          share(kCache, kBytes)});
  }
  section.add(std::move(table));
}

}  // namespace quicksand::bench
