#include "core/interior_point/contact_matrix.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/memory.h"

namespace quicksand {

namespace {

// What a contact adds to the blocks of its bodies: X^T D Y, up to a sign, where X and Y take the motion of a body to
// that of its contact point, [R s; 0 1] with the rows n and t of R and s the velocity there of a unit spin. The first
// two columns of a block depend on the body of its row only, so eight columns make the four blocks.
enum Column { first_a, second_a, first_b, second_b, spin_aa, spin_ab, spin_ba, spin_bb };
constexpr std::size_t kColumns = spin_bb + 1;

// The columns of four contacts: column k of contact c from out[c] + 4 k on.
QUICKSAND_IN_LANES void find_columns(const RowLanes& row, const Impedance<Lanes>& d,
                                     std::array<double, 4 * kColumns>* out) {
  const Lanes nx = row.normal_x, ny = row.normal_y;
  // D applied to the rows of R, in space: n stands for the first column of D, t = (-ny, nx) for the second.
  const Lanes nn_x = d.nn * nx - d.tn * ny, nn_y = d.nn * ny + d.tn * nx;
  const Lanes tt_x = -d.tt * ny, tt_y = d.tt * nx;
  const Lanes zero{};
  const auto put = [&](Column column, Lanes x, Lanes y, Lanes z) __attribute__((always_inline)) {
    Lanes w = zero;
    transpose(x, y, z, w);
    store_lanes(x, out[0].data() + 4 * column);
    store_lanes(y, out[1].data() + 4 * column);
    store_lanes(z, out[2].data() + 4 * column);
    store_lanes(w, out[3].data() + 4 * column);
  };
  const Lanes xx = nn_x * nx - tt_x * ny, yx = nn_y * nx - tt_y * ny;
  const Lanes xy = nn_x * ny + tt_x * nx, yy = nn_y * ny + tt_y * nx;
  const auto torque = [&](const Lanes& s_n, const Lanes& s_t, Lanes& n, Lanes& t)
      __attribute__((always_inline)) {
    n = s_n * d.nn + s_t * d.tn + d.rn;
    t = s_t * d.tt;
  };
  Lanes an, at, bn, bt;
  torque(row.spin_a_n, row.spin_a_t, an, at);
  torque(row.spin_b_n, row.spin_b_t, bn, bt);
  put(first_a, xx, yx, an * nx - at * ny);
  put(second_a, xy, yy, an * ny + at * nx);
  put(first_b, xx, yx, bn * nx - bt * ny);
  put(second_b, xy, yy, bn * ny + bt * nx);
  // By a unit spin of a body.
  const Lanes ua_x = row.spin_a_n * nn_x + row.spin_a_t * tt_x;
  const Lanes ua_y = row.spin_a_n * nn_y + row.spin_a_t * tt_y;
  const Lanes ub_x = row.spin_b_n * nn_x + row.spin_b_t * tt_x;
  const Lanes ub_y = row.spin_b_n * nn_y + row.spin_b_t * tt_y;
  put(spin_aa, ua_x, ua_y, an * row.spin_a_n + at * row.spin_a_t + d.rr);
  put(spin_ab, ub_x, ub_y, an * row.spin_b_n + at * row.spin_b_t + d.rr);
  put(spin_ba, ua_x, ua_y, bn * row.spin_a_n + bt * row.spin_a_t + d.rr);
  put(spin_bb, ub_x, ub_y, bn * row.spin_b_n + bt * row.spin_b_t + d.rr);
}

// A block that is summed up in registers.
struct alignas(sizeof(Lanes)) BlockSum {
  Lanes column[3];

  QUICKSAND_IN_LANES void add(const std::array<double, 4 * kColumns>& columns, int first,
                              int second, int spin) {
    Lanes x, y, z;
    load_lanes(columns.data() + 4 * first, x);
    load_lanes(columns.data() + 4 * second, y);
    load_lanes(columns.data() + 4 * spin, z);
    column[0] += x, column[1] += y, column[2] += z;
  }
};

// The mass of a body along a direction in which it cannot move: beside it all impedances are below rounding.
constexpr double kHeld = 1e50;

}  // namespace

void ContactMatrix::attach(const ContactProblem& problem) {
  const WorkClock::Span span(clock_, Work::factorisation);
  problem_ = &problem;
  edges_.clear();
  edges_.reserve(problem.contacts.size());
  edge_of_contact_.assign(problem.contacts.size(), -1);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    if (problem.inverse_mass[row.a].isZero(0) || problem.inverse_mass[row.b].isZero(0)) continue;
    edge_of_contact_[c] = static_cast<int>(edges_.size());
    edges_.push_back({row.a, row.b});
  }
  lu_.analyse(static_cast<int>(problem.inverse_mass.size()), edges_);
  place_bodies();
  order_contacts();
  place_contacts();
  list_sides();
  list_parts();
}

void ContactMatrix::place_bodies() {
  const ContactProblem& problem = *problem_;
  const std::size_t nb = problem.inverse_mass.size();
  place_.resize(nb);
  inverse_mass_.resize(nb);
  free_velocity_.resize(nb);
  diagonal_.resize(nb);
  for (std::size_t i = 0; i < nb; ++i) {
    place_[i] = lu_.position(static_cast<int>(i));
    const auto place = static_cast<std::size_t>(place_[i]);
    diagonal_[place] = &lu_.diagonal(static_cast<int>(i));
    inverse_mass_[place] << problem.inverse_mass[i], 0;
    free_velocity_[place] << problem.free_velocity[i], 0;
  }
}

void ContactMatrix::order_contacts() {
  by_first_.fill(place_.size(), [&](const auto& use) {
    int c = 0;
    for (const ContactRow& row : problem_->contacts)
      use(std::min(place_[row.a], place_[row.b]), c++);
  });
}

void ContactMatrix::place_contacts() {
  const ContactProblem& problem = *problem_;
  const std::size_t nc = problem.contacts.size();
  set_size(rows_, lane_blocks(nc));
  set_size(momentum_, 2 * kLanes * rows_.size());
  set_size(columns_, kLanes * rows_.size());
  coupling_.clear();
  coupling_.reserve(edges_.size());
  for (std::size_t c = 0; c < kLanes * rows_.size(); ++c) {
    const auto contact_here = static_cast<std::size_t>(order()[c < nc ? c : 0]);
    const ContactRow& contact = problem.contacts[contact_here];
    RowLanes& row = rows_[c / kLanes];
    const std::size_t k = c % kLanes;
    row.a[k] = place_[contact.a];
    row.b[k] = place_[contact.b];
    row.normal_x[k] = contact.normal.x();
    row.normal_y[k] = contact.normal.y();
    row.spin_a_n[k] = contact.spin_a.x();
    row.spin_a_t[k] = contact.spin_a.y();
    row.spin_b_n[k] = contact.spin_b.x();
    row.spin_b_t[k] = contact.spin_b.y();
    row.offset.n[k] = contact.offset.x();
    row.offset.t[k] = contact.offset.y();
    row.offset.r[k] = contact.offset.z();
    if (c >= nc) continue;
    const int edge = edge_of_contact_[contact_here];
    if (edge < 0) continue;
    coupling_.push_back(
        {.contact = static_cast<int>(c), .ab = &lu_.upper(edge), .ba = &lu_.lower(edge)});
  }
}

void ContactMatrix::list_sides() {
  sides_.fill(place_.size(), [&](const auto& use) {
    for (std::size_t c = 0; c < order().size(); ++c) {
      const RowLanes& row = rows_[c / kLanes];
      use(row.a[c % kLanes], static_cast<int>(2 * c));
      use(row.b[c % kLanes], static_cast<int>(2 * c + 1));
    }
  });
}

void ContactMatrix::list_parts() {
  const auto parts = static_cast<std::size_t>(lu_.parts());
  bodies_of_part_.fill(parts, [&](const auto& use) {
    for (int i = 0; i < static_cast<int>(place_.size()); ++i) use(lu_.part_of(i), i);
  });
  couplings_of_part_.fill(parts, [&](const auto& use) {
    int k = 0;
    for (const Coupling& c : coupling_) {
      const RowLanes& row = rows_[static_cast<std::size_t>(c.contact) / kLanes];
      const std::size_t lane = static_cast<std::size_t>(c.contact) % kLanes;
      use(lu_.part_of(std::min(row.a[lane], row.b[lane])), k++);
    }
  });
}

QUICKSAND_IN_LANES void ContactMatrix::put_diagonal(std::size_t body) {
  const Eigen::Vector4d& im = inverse_mass_[body];
  BlockSum sum{};
  for (const int k : sides_.of(body)) {
    const auto side = static_cast<std::size_t>(k);
    if (side % 2 == 0)
      sum.add(columns_[side / 2], first_a, second_a, spin_aa);
    else
      sum.add(columns_[side / 2], first_b, second_b, spin_bb);
  }
  for (int d = 0; d < 3; ++d) {
    sum.column[d][d] += im[d] > 0 ? 1 / im[d] : kHeld;
    store_lanes(sum.column[d], diagonal_[body]->column[d]);
  }
}

// Two contacts may couple the same bodies: they are in one part, and add up.
QUICKSAND_IN_LANES void ContactMatrix::add_coupling(const Coupling& c) {
  const auto contact = static_cast<std::size_t>(c.contact);
  BlockSum ab{}, ba{};
  ab.add(columns_[contact], first_a, second_a, spin_ab);
  ba.add(columns_[contact], first_b, second_b, spin_ba);
  for (int d = 0; d < 3; ++d) {
    Lanes x, y;
    load_lanes(c.ab->column[d], x);
    load_lanes(c.ba->column[d], y);
    store_lanes(x - ab.column[d], c.ab->column[d]);
    store_lanes(y - ba.column[d], c.ba->column[d]);
  }
}

void ContactMatrix::factorise(const std::vector<Impedance<Lanes>>& impedance) {
  WorkClock::look_up(clock_);
  const WorkClock::Span span(clock_, Work::factorisation);
  for_lane_blocks(
      kLanes * rows_.size(), [&](std::size_t k) __attribute__((always_inline)) {
        find_columns(rows_[k], impedance[k], columns_.data() + kLanes * k);
      });
  const auto fill = [&](int part) {
    const auto index = static_cast<std::size_t>(part);
    with_lanes([&]() __attribute__((always_inline)) {
      for (const int i : bodies_of_part_.of(index)) put_diagonal(static_cast<std::size_t>(i));
      for (const int k : couplings_of_part_.of(index))
        add_coupling(coupling_[static_cast<std::size_t>(k)]);
    });
  };
  lu_.factorise(std::ref(fill));  // as a reference it is not allocated
}

void ContactMatrix::factorise(const std::vector<Impedance<double>>& impedance) {
  set_size(packed_, rows_.size());
  for (std::size_t c = 0; c < impedance.size(); ++c) {
    Impedance<Lanes>& d = packed_[c / kLanes];
    const std::size_t k = c % kLanes;
    const Impedance<double>& of_contact = impedance[static_cast<std::size_t>(order()[c])];
    d.nn[k] = of_contact.nn;
    d.tn[k] = of_contact.tn;
    d.tt[k] = of_contact.tt;
    d.rn[k] = of_contact.rn;
    d.rr[k] = of_contact.rr;
  }
  factorise(packed_);
}

template <class Put>
[[gnu::always_inline]] inline void ContactMatrix::sum_momenta(const Put& put) const {
  share_in_lanes(
      place_.size(), [&](std::size_t i) __attribute__((always_inline)) {
        Lanes sum{};
        for (const int side : sides_.of(i)) {
          Lanes p;
          load_lanes(momentum_[static_cast<std::size_t>(side)].data(), p);
          sum += p;
        }
        put(i, sum);
      });
}

const BodyVectors& ContactMatrix::velocity_change() {
  const WorkClock::Span span(clock_, Work::back_substitution);
  change_.resize(place_.size());
  sum_momenta([&](std::size_t i, const Lanes& sum)
                  __attribute__((always_inline)) { store_lanes(sum, change_[i].data()); });
  lu_.solve(change_.data());
  return change_;
}

void ContactMatrix::velocity(BodyVectors& velocity) const {
  const WorkClock::Span span(clock_, Work::back_substitution);
  velocity.resize(place_.size());
  sum_momenta([&](std::size_t i, const Lanes& sum) __attribute__((always_inline)) {
    Lanes free, im;
    load_lanes(free_velocity_[i].data(), free);
    load_lanes(inverse_mass_[i].data(), im);
    store_lanes(free + im * sum, velocity[i].data());
  });
}

void ContactMatrix::velocity_change(const std::vector<Vec3>& impulse, std::vector<Vec3>& dv) {
  for (std::size_t c = 0; c < impulse.size(); ++c) {
    const auto contact = static_cast<std::size_t>(order()[c]);
    const ContactRow& row = problem_->contacts[contact];
    momentum_[2 * c] << momentum_of_a(row, impulse[contact]), 0;
    momentum_[2 * c + 1] << momentum_of_b(row, impulse[contact]), 0;
  }
  velocity_change();
  dv.resize(place_.size());
  for (std::size_t i = 0; i < dv.size(); ++i)
    dv[i] = change_[static_cast<std::size_t>(place_[i])].head<3>();
}

double ContactMatrix::fastest_change() const {
  const Vec3 rest = Vec3::Zero();
  double squared = 0;
  for (const ContactRow& row : problem_->contacts) {
    const Vec3 a = change_[static_cast<std::size_t>(place_[row.a])].head<3>();
    const Vec3 b = change_[static_cast<std::size_t>(place_[row.b])].head<3>();
    const double of_a = relative_velocity(row, a, rest).head<2>().squaredNorm(),
                 of_b = relative_velocity(row, rest, b).head<2>().squaredNorm();
    // What is no number is no small change.
    if (std::isnan(of_a + of_b)) return std::numeric_limits<double>::infinity();
    squared = std::max({squared, of_a, of_b});
  }
  return std::sqrt(squared);
}

}  // namespace quicksand
