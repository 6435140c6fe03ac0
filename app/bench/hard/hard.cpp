// Hard cases: problems with a known answer at which solvers fail, with how far ours is off.
#include <algorithm>

#include "app/bench/hard/hard_run.h"

namespace quicksand::bench {

std::vector<Task> hard_tasks(const Options& options) {
  std::vector<HardCase> cases = structure_cases(options);
  std::ranges::move(motion_cases(options), std::back_inserter(cases));
  return tasks_of(cases, options, [](const HardCase& one, const Options&, std::vector<Row>& rows) {
    rows.push_back(one.run());
  });
}

void report_hard(std::span<const Row> rows, const Options&, Section& section) {
  const auto passed =
      std::ranges::count_if(rows, [](const Row& row) { return row.passed.value_or(false); });
  section.add(Paragraph{
      format("%d of %zu answers are right. Every case runs at the program's defaults (method auto, "
             "tolerance 1e-6, dt = 1e-2; spinning pairs 1e-3) unless its name says otherwise. What "
             "is expected is a closed form: the balance of forces or moments at the contact law's "
             "limits, and momentum. How far off is in the unit of the bound that the answer must "
             "keep. Some cases are run at a smaller tolerance as well, which their name says.",
             static_cast<int>(passed), rows.size())});
  Table table{
      .columns = {
          {"case"}, {"expected"}, {"ours"}, {"off by", true}, {"verdict"}, {"seconds", true}}};
  for (const Row& row : rows) {
    const bool right = row.passed.value_or(false);
    table.rows.push_back(
        {{row.name},
         {row.expected.empty() ? "an answer" : row.expected},
         {row.found},
         {row.error ? format("%.1e", *row.error) + (row.unit == "1" ? "" : " " + row.unit) : "-"},
         {right ? "pass" : "FAIL", right ? Cell::Mark::inside : Cell::Mark::outside},
         {row.seconds.cpu > 0 ? format("%.2g", row.seconds.cpu) : "-"}});
  }
  section.add(std::move(table));
}

}  // namespace quicksand::bench
