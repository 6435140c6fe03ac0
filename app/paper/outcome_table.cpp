#include "app/paper/outcome_table.h"

#include <array>

namespace quicksand {

namespace {

struct Outcome {
  const char* quantity;
  const char* title;
};

constexpr Outcome kActive{"active_bond_fraction", "active of contacts"};
constexpr Outcome kRemaining{"remaining_bond_fraction", "remaining of initial"};
constexpr Outcome kCoordination{"coordination", "coordination"};

Table outcomes(const PaperResults& results, const std::string& caption,
               const std::vector<OutcomeRow>& rows, int all, const std::array<Outcome, 4>& of) {
  Table table{.caption = caption, .columns = {{"case"}}};
  for (const Outcome& outcome : of) table.columns.push_back({outcome.title, true});
  for (const OutcomeRow& row : rows) {
    std::vector<Cell> cells{{.text = row.text}};
    for (const Outcome& outcome : of)
      cells.push_back(cell_of(results.mean(row.runs, outcome.quantity), all));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

Table push_outcomes(const PaperResults& results, const std::string& caption,
                    const std::vector<OutcomeRow>& rows, int all) {
  return outcomes(results, caption, rows, all,
                  {{{"depth", "depth [d]"}, kActive, kRemaining, kCoordination}});
}

Table piston_outcomes(const PaperResults& results, const std::string& caption,
                      const std::vector<OutcomeRow>& rows, int all) {
  return outcomes(results, caption, rows, all,
                  {{{"volume_fraction", "volume fraction"}, kActive, kRemaining, kCoordination}});
}

}  // namespace quicksand
