#include "app/campaign/campaign_fields.h"

#include <algorithm>

#include "app/json/name_field.h"
#include "app/scene_json/scene_shapes.h"

namespace quicksand {

namespace {

constexpr std::size_t kMaxOptions = 100;

bool is_values(const Json& value) { return value.is_array() && !value.empty(); }

// That each path has a list is checked, and said of that path, when the runs are made.
constexpr Shape kGrid{"an object of scene paths, each with a list of at least one value",
                      kSetShape.fits, [] {
                        Json schema = kSetShape.schema();
                        schema["additionalProperties"] = {{"type", "array"}, {"minItems", 1}};
                        return schema;
                      }};

constexpr Shape kList{
    "a list of at least one object of scene paths with their values",
    [](const Json& v) { return is_values(v) && std::ranges::all_of(v, kSetShape.fits); },
    [] {
      return Json{{"type", "array"}, {"minItems", 1}, {"items", kSetShape.schema()}};
    }};

// A word that is no option would be taken for the script, or for its first argument.
bool is_option(const Json& value) {
  return value.is_string() && value.get_ref<const std::string&>().starts_with("--");
}

constexpr Shape kOptions{
    "a list of texts, each beginning with \"--\"",
    [](const Json& v) {
      return v.is_array() && v.size() <= kMaxOptions && std::ranges::all_of(v, is_option);
    },
    [] {
      const Json option = {{"type", "string"}, {"pattern", "^--"}};
      return Json{{"type", "array"}, {"maxItems", kMaxOptions}, {"items", option}};
    }};

void describe_slurm(Fields& f, SlurmOptions& slurm) {
  f.text({"partition", "sbatch --partition"}, slurm.partition);
  f.text({"time", "limit of a task, sbatch --time, as in 01:00:00"}, slurm.time);
  f.text({"memory", "of a task, sbatch --mem, as in 2G"}, slurm.memory);
  f.json({"options", "further options of sbatch, as in --account=soil"}, kOptions, slurm.options);
}

}  // namespace

void describe_campaign(Fields& f, Campaign& c) {
  std::string schema;  // for editors; means nothing to the program
  f.text({"$schema", "path of this schema, for editors"}, schema);
  describe_name(f, c.name);
  f.text({"description", "what the campaign is for"}, c.description);
  f.json({"scene", "base scene: a path relative to this file, or the scene itself",
          Presence::required},
         kSceneShape, c.scene);
  f.json({"set", "values for all runs, by their paths in the scene, as in run --set"}, kSetShape,
         c.set);
  f.json({"grid", "lists of values, by their paths in the scene; all combinations are run"}, kGrid,
         c.grid);
  f.json({"list",
          "points, each with values by their paths in the scene; with a grid, each point "
          "with each combination"},
         kList, c.list);
  f.integer({"realizations", "runs of each point, with the seeds s, s+1, ... from the scene's s"},
            1, kMaxRuns, c.realizations);
  f.flag({"frames", "whether runs draw pictures"}, c.frames);
  f.integer({"chunk", "runs that a Slurm task computes, one after the other"}, 1, kMaxRuns,
            c.chunk);
  f.object({"slurm", "what sbatch is told with --engine slurm"},
           [&](Fields& g) { describe_slurm(g, c.slurm); });
}

}  // namespace quicksand
