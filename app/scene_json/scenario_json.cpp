#include "app/scene_json/scenario_json.h"

#include "app/json/json_reader.h"
#include "app/json/json_schema.h"
#include "app/json/json_writer.h"
#include "app/scene_json/scene_fields.h"

namespace quicksand {

Scenario scenario_from_json(const Json& json) {
  Scenario scenario;
  read_fields(json, "a scene", [&](Fields& f) { describe_scene(f, scenario); });
  return scenario;
}

Json to_json(const Scenario& scenario) { return written_fields(scenario, describe_scene); }

std::string to_text(const Scenario& scenario) { return to_json(scenario).dump(2) + "\n"; }

Json scene_schema() {
  Scenario defaults;
  return file_schema(
      "quicksand scene",
      "Units: d = grain diameter, F_g = weight of a grain, time sqrt(d/g). Generated "
      "by `quicksand list schema`.",
      [&](Fields& f) { describe_scene(f, defaults); });
}

}  // namespace quicksand
