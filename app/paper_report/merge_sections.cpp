#include "app/paper_report/merge_sections.h"

#include <algorithm>
#include <map>

#include "app/targets/comparison.h"

namespace quicksand {

namespace {

constexpr const char* kNamed = ": ";  // between a method and what is its alone

// Puts the method in front of what is its alone, and draws its curves in its colour: markers and dashes tell apart
// what a plot of one method tells apart by colours.
struct Named {
  const std::string& method;

  void operator()(Paragraph& block) const { block.text = method + ": " + block.text; }
  void operator()(Remark& block) const { block.text = method + ": " + block.text; }
  void operator()(BulletList& /*block*/) const {}
  void operator()(Verbatim& /*block*/) const {}
  void operator()(Table& block) const { block.caption = method + ": " + block.caption; }
  void operator()(Gallery& block) const {
    for (Gallery::Picture& picture : block.pictures)
      picture.caption = method + ", " + picture.caption;
  }
  void operator()(Figure& block) const {
    std::size_t ours = 0;
    for (Curve& curve : block.plot.curves) {
      const bool of_paper = curve.role == Curve::Role::paper;
      if (!of_paper && !curve.name.empty()) curve.name = method + ": " + curve.name;
      if (curve.role == Curve::Role::ours && !curve.style) curve.style = ours++;
      curve.colour = of_paper ? std::nullopt : std::optional(method_colour(method));
    }
    for (Reference& reference : block.plot.references)
      if (reference.role == Reference::Role::guide && !reference.name.empty())
        reference.name = method + kNamed + reference.name;
  }
};

// A guide that is of both methods, at the same place, is named as that of neither.
void add_reference(Plot& plot, const std::string& method, Reference&& added) {
  const bool guide = added.role == Reference::Role::guide && !added.name.empty();
  const std::string own = guide ? added.name.substr((method + kNamed).size()) : added.name;
  for (Reference& known : plot.references) {
    if (known.name == added.name) return;
    if (guide && known.role == Reference::Role::guide && known.of_x == added.of_x &&
        known.low == added.low && known.high == added.high && known.name.ends_with(kNamed + own)) {
      known.name = own;
      return;
    }
  }
  plot.references.push_back(std::move(added));
}

void add_to(Plot& plot, const std::string& method, Plot&& other) {
  const auto has_curve = [&](const Curve& curve) {
    return std::ranges::any_of(plot.curves, [&](const Curve& c) {
      return c.role == Curve::Role::paper && c.name == curve.name;
    });
  };
  for (Curve& curve : other.curves)
    if (curve.role != Curve::Role::paper || !has_curve(curve))
      plot.curves.push_back(std::move(curve));
  for (Reference& reference : other.references) add_reference(plot, method, std::move(reference));
  std::ranges::move(other.annotations, std::back_inserter(plot.annotations));
  plot.legend = LegendPlace::below;  // there is more in it
}

// The first column names the rows.
bool has_numbers(const Table& table) {
  return std::ranges::any_of(table.rows, [](const std::vector<Cell>& row) {
    return std::any_of(row.begin() + 1, row.end(), [](const Cell& cell) {
      return !cell.text.empty() && cell.text != "-" && cell.text != "0";
    });
  });
}

}  // namespace

Section merge_sections(std::vector<std::pair<std::string, Section>> parts) {
  if (parts.size() == 1) return std::move(parts.front().second);
  Section merged{.title = parts.front().second.title, .blocks = {}};
  std::map<std::string, std::size_t> plots;  // place of each among the blocks
  for (auto& [method, section] : parts)
    for (Block& block : section.blocks) {
      std::visit(Named{method}, block);
      if (auto* figure = std::get_if<Figure>(&block)) {
        const auto [known, is_new] = plots.emplace(figure->plot.name, merged.blocks.size());
        if (!is_new) {
          add_to(std::get<Figure>(merged.blocks[known->second]).plot, method,
                 std::move(figure->plot));
          continue;
        }
      }
      merged.blocks.push_back(std::move(block));
    }
  return merged;
}

bool drop_empty_blocks(Section& section) {
  std::erase_if(section.blocks, [](const Block& block) {
    if (const auto* figure = std::get_if<Figure>(&block)) return !has_values(figure->plot);
    if (const auto* table = std::get_if<Table>(&block)) return !has_numbers(*table);
    return false;
  });
  return std::ranges::any_of(section.blocks, [](const Block& block) {
    return std::holds_alternative<Figure>(block) || std::holds_alternative<Table>(block);
  });
}

}  // namespace quicksand
