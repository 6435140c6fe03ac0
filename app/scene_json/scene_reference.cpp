#include "app/scene_json/scene_reference.h"

#include <cctype>
#include <set>

#include "app/json/schema_tables.h"
#include "app/scene_json/phase_fields.h"
#include "app/scene_json/scenario_json.h"

namespace quicksand {

namespace {

constexpr const char* kIntroduction = R"(# Reference of scenes

For users who write scenes: every key, its values, default and meaning. `quicksand list scene_reference` prints this page; how
scenes are built is in [scenes.md](scenes.md).

Units: d is the grain diameter, r = d/2, F_g the weight of a grain, F_c the cohesion force, sqrt(d/g) the unit of time. A path
such as `step.dt` or `phases[1].force` names a key in `--set`, in campaigns and in sessions. A key without a default may be
left out; its meaning says what applies then.
)";

constexpr const char* kPhaseKinds = R"(
## Phases

`phases` lists what happens, in order. The `type` of each phase is one of the following.
)";

// An object, or a list of objects, has a section of its own.
const Json* fields_of(const Json& schema) {
  if (schema.contains("properties")) return &schema;
  if (schema.contains("items") && schema["items"].contains("properties")) return &schema["items"];
  return nullptr;
}

std::string section(const std::string& key, const Json& schema, const Json& scene) {
  std::string meaning = schema["description"];
  meaning[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(meaning[0])));
  std::string text = "\n## " + key + "\n\n" + meaning + ".";
  if (schema.contains("items"))
    text += " A list of at most " + schema["maxItems"].dump() + " objects.";
  text += "\n\n";
  const Json& contact = scene["properties"]["contact"];
  const Json& fields = *fields_of(schema);
  if (key != "contact" && fields["properties"] == contact["properties"])
    return text + "Its keys are those of [contact](#contact).\n";
  return text + key_table(fields);
}

}  // namespace

std::string scene_reference() {
  const Json scene = scene_schema();
  std::string general, sections;
  std::set<std::string> left_out{"phases"};
  for (const auto& [key, schema] : scene["properties"].items()) {
    if (fields_of(schema) == nullptr) continue;
    left_out.insert(key);
    sections += section(key, schema, scene);
  }
  general = "\n## Scene\n\n" + key_table(scene, left_out);
  std::string phases = kPhaseKinds;
  const Json& schemas = scene["properties"]["phases"]["items"]["oneOf"];
  for (std::size_t k = 0; k < schemas.size(); ++k) {
    const PhaseKind& kind = phase_kinds()[k];
    phases += "\n### " + std::string(kind.name) + "\n\n" + std::string(kind.sentence) + "\n\n" +
              key_table(schemas[k], {"type"});
  }
  return kIntroduction + general + sections + phases;
}

}  // namespace quicksand
