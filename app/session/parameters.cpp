#include "app/session/parameters.h"

#include <algorithm>
#include <map>

#include "app/json/fields.h"
#include "app/scene_json/scene_fields.h"

namespace quicksand {

namespace {

// Visits a description and keeps every number, integer, flag and word with its path.
class ParameterList : public Fields {
 public:
  explicit ParameterList(std::string path) : path_(std::move(path)) {}

  std::vector<Parameter> take() { return std::move(found_); }

  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override {
    // Called as what it is the type of.
    Parameter p{.path = path_of(field),
                .label = path_.substr(path_.rfind('.') + 1),
                .help = field.help,
                .unit = "1"};
    p.kind = Parameter::Kind::word;
    p.words.assign(words.begin(), words.end());
    p.value = words[static_cast<std::size_t>(index)];
    found_.push_back(std::move(p));
    visit(*this, index);
  }

 protected:
  void leaf(const Field& field, const Leaf& leaf) override {
    using enum Parameter::Kind;
    static const std::map<Json, Parameter::Kind> kinds{
        {"number", number}, {"integer", integer}, {"boolean", flag}, {"", word}};
    const Json schema = leaf.schema();
    const auto kind = kinds.find(schema.contains("enum") ? Json("") : schema.value("type", Json()));
    if (kind == kinds.end()) return;  // a panel has no entry for the others
    Parameter& p = found_.emplace_back();
    p.path = path_of(field);
    p.label = field.name;
    std::ranges::replace(p.label, '_', ' ');
    p.help = field.help;
    p.unit = leaf.unit != nullptr ? leaf.unit : "1";
    p.kind = kind->second;
    p.above_low = schema.contains("exclusiveMinimum");
    p.low = schema.value(p.above_low ? "exclusiveMinimum" : "minimum", p.low);
    p.high = schema.value("maximum", p.high);
    p.words = schema.value("enum", p.words);
    p.value = leaf.write();
  }
  bool begin_optional(const Field& field, bool present, const Visit& visit) override {
    if (present) inside(field.name, visit);
    return false;
  }
  void items(const Field& field, std::size_t /*most*/, std::size_t size,
             const std::function<void(std::size_t)>& /*resize*/, const VisitItem& visit) override {
    for (std::size_t i = 0; i < size; ++i) {
      inside(field.name + ("[" + std::to_string(i) + "]"), [&](Fields& f) { visit(f, i); });
    }
  }

 private:
  std::string path_of(const Field& field) const {
    return path_ + (path_.empty() ? "" : ".") + field.name;
  }
  void inside(const std::string& name, const Visit& visit) {
    const std::string outside = path_;
    path_ += (path_.empty() ? "" : ".") + name;
    visit(*this);
    path_ = outside;
  }

  std::string path_;
  std::vector<Parameter> found_;
};

std::vector<Parameter> all_of(Scenario scenario) {
  // Bodies can be many, and a panel shows none of them.
  scenario.disks.clear();
  scenario.disk_forces.clear();
  scenario.walls.clear();
  ParameterList list("");
  describe_scene(list, scenario);
  return list.take();
}

using Names = std::vector<const char*>;

// Adds those of `all` that lie in `folder` and have one of these names, in the order of the names.
void add(ParameterGroup& group, const std::vector<Parameter>& all, const std::string& folder,
         const Names& names) {
  for (const char* name : names) {
    const std::string path = folder + (folder.empty() ? "" : ".") + name;
    const auto found = std::ranges::find(all, path, &Parameter::path);
    if (found != all.end()) group.parameters.push_back(*found);
  }
}

template <class Kind>
bool is(const Phase& phase) {
  return std::holds_alternative<Kind>(phase.kind);
}

// Of the first phase of that kind; if the scene has none, without values, under the name of the kind.
template <class Kind>
ParameterGroup group_of(const char* name, const Scenario& scenario,
                        const std::vector<Parameter>& all, const Names& names) {
  ParameterGroup group{name, {}};
  const auto first = std::ranges::find_if(scenario.phases, is<Kind>);
  if (first != scenario.phases.end()) {
    const auto k = first - scenario.phases.begin();
    add(group, all, "phases[" + std::to_string(k) + "]", names);
    return group;
  }
  Phase absent{.kind = Kind{}};
  ParameterList list{std::string(Kind::kName)};
  describe_phase(list, absent, scenario);
  add(group, list.take(), std::string(Kind::kName), names);
  for (Parameter& p : group.parameters) p.value = nullptr;
  return group;
}

}  // namespace

std::vector<ParameterGroup> parameters_of(const Scenario& scenario) {
  const std::vector<Parameter> all = all_of(scenario);
  ParameterGroup contacts{"Contacts", {}}, computing{"Computing", {}};
  add(contacts, all, "contact",
      Names{"cohesion_force", "cohesion_range", "friction", "rolling_friction"});
  add(computing, all, "", Names{"seed", "method"});
  // Beside that of the solver.
  if (computing.parameters.size() == 2) computing.parameters.back().label = "step method";
  add(computing, all, "nscd", Names{"sweeps", "order"});
  add(computing, all, "step", Names{"dt", "max_turn", "break_rule"});
  computing.parameters.back().label = "failure criterion";
  add(computing, all, "solver", Names{"method", "tolerance"});
  std::vector<ParameterGroup> groups{
      std::move(contacts),
      group_of<DepositPhase>("Deposition", scenario, all,
                             Names{"height", "interval", "drop_velocity"}),
      group_of<PushPhase>("Intruder", scenario, all, Names{"diameter", "density", "force"}),
      group_of<PistonPhase>("Piston", scenario, all, Names{"mass", "force", "ramp_time"})};
  // Of other intruders those that the scene drives.
  if (std::ranges::any_of(scenario.phases, is<PenetratePhase>))
    groups.push_back(group_of<PenetratePhase>(
        "Penetration", scenario, all,
        Names{"shape.type", "shape.width", "shape.diameter", "shape.angle", "shape.radius",
              "shape.thickness", "shape.length", "shape.tilt", "shape.rod_width",
              "shape.rod_length", "density", "speed", "force", "ramp_time", "depth"}));
  if (std::ranges::any_of(scenario.phases, is<VanePhase>))
    groups.push_back(
        group_of<VanePhase>("Vane", scenario, all,
                            Names{"shape.blades", "shape.radius", "shape.thickness",
                                  "angular_velocity", "torque", "ramp_time", "angle"}));
  if (std::ranges::any_of(scenario.phases, is<SlidePhase>))
    groups.push_back(
        group_of<SlidePhase>("Slide", scenario, all, Names{"speed", "distance", "ramp_time"}));
  groups.push_back(std::move(computing));
  return groups;
}

}  // namespace quicksand
