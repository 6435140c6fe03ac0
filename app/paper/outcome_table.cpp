#include "app/paper/outcome_table.h"

namespace quicksand {

Table outcome_table(const PaperResults& results, const std::string& caption, const Column& first,
                    const std::vector<OutcomeRow>& rows, std::span<const FinalQuantity> of,
                    int all) {
  Table table{.caption = caption, .columns = {first}};
  for (const FinalQuantity& outcome : of) table.columns.push_back({outcome.title, true});
  for (const OutcomeRow& row : rows) {
    std::vector<Cell> cells{{.text = row.text}};
    for (const FinalQuantity& outcome : of)
      cells.push_back(cell_of(results.mean(row.runs, outcome.quantity), all));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace quicksand
