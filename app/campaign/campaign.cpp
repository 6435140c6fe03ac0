#include "app/campaign/campaign.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "app/base/nearest_name.h"
#include "app/json/json_reader.h"
#include "app/json/json_schema.h"
#include "app/json/json_writer.h"
#include "app/json/name_field.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/scene_shapes.h"
#include "core/base/errors.h"

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
  f.text({"partition", "partition, as for sbatch --partition"}, slurm.partition);
  f.text({"time", "time limit of a task, as for sbatch --time, e.g. 01:00:00"}, slurm.time);
  f.text({"memory", "memory of a task, as for sbatch --mem, e.g. 2G"}, slurm.memory);
  f.json({"options", "further options of sbatch, e.g. --account=soil"}, kOptions, slurm.options);
}

void describe_campaign(Fields& f, Campaign& c) {
  describe_heading(f, c.name, c.description, "purpose of the campaign");
  f.json(
      {"scene",
       "base scene: a path relative to this file, the name of a shipped scene, or the scene itself",
       Presence::required},
      kSceneShape, c.scene);
  f.json({"set", "values for all runs, by path in the scene, as in run --set"}, kSetShape, c.set);
  f.json({"grid", "lists of values, by path in the scene; all combinations are run"}, kGrid,
         c.grid);
  f.json({"list",
          "points, each with values by path in the scene; with a grid, each point is run with each "
          "combination"},
         kList, c.list);
  f.integer(
      {"realizations", "runs of each point, with seeds s, s+1, ..., where s is the scene's seed"},
      1, kMaxRuns, c.realizations);
  f.flag({"frames", "whether runs draw pictures"}, c.frames);
  f.object({"report", "results that `report` shows"},
           [&](Fields& g) { describe_report(g, c.report); });
  f.integer({"chunk", "runs per Slurm task, computed one after the other"}, 1, kMaxRuns, c.chunk);
  f.object({"slurm", "settings for sbatch with --engine slurm"},
           [&](Fields& g) { describe_slurm(g, c.slurm); });
}

namespace fs = std::filesystem;

// The scene in place of its path, and no path relative to where the files are.
void make_self_contained(Campaign& campaign, const fs::path& file) {
  const fs::path here = fs::absolute(file).parent_path();
  fs::path folder = here;
  std::optional<fs::path> scene;  // its file
  if (campaign.scene.is_string()) {
    try {
      scene = scene_named(campaign.scene.get<std::string>(), file.parent_path());
      campaign.scene = parse_json(read_scene_text(*scene));
    } catch (const InputError& error) {
      const std::string where = error.where().empty() && scene ? scene->string() : error.where();
      throw InputError(where.empty() ? "scene" : "scene: " + where, error.what(), error.nearest());
    }
    folder = fs::absolute(*scene).parent_path();
    if (!campaign.scene.is_object()) {
      throw InputError("scene: " + scene->string(),
                       "is " + described(campaign.scene) + ", must be an object {...}");
    }
  }
  if (!campaign.scene.contains("name"))
    campaign.scene["name"] = scene ? name_of(*scene) : campaign.name;
  make_start_absolute(campaign.scene, folder);
  make_start_absolute(campaign.set, here);
  for (Json& point : campaign.list) make_start_absolute(point, here);
  if (campaign.grid.contains(kStartFrom)) {
    for (Json& path : campaign.grid[kStartFrom]) path = start_in(here, path);
  }
}

// Before anything is computed, not when the report is asked for.
void require_axis(const Campaign& campaign) {
  const std::string& path = campaign.report.x.path;
  const std::vector<std::string> paths = parameter_paths(campaign);
  if (!path.empty())
    named(paths, path, std::identity(), "report.x.path",
          "is \"" + path + "\", which is no parameter that varies");
}

}  // namespace

Campaign read_campaign(const fs::path& file) {
  return in_file(file, [&] {
    Campaign campaign;
    read_fields(read_json(file), "a campaign", [&](Fields& f) { describe_campaign(f, campaign); });
    if (campaign.name.empty()) campaign.name = name_of(file);
    require_axis(campaign);
    make_self_contained(campaign, file);
    return campaign;
  });
}

std::string to_text(const Campaign& campaign) {
  return written_fields(campaign, describe_campaign).dump(2) + "\n";
}

std::vector<std::string> parameter_paths(const Campaign& campaign) {
  std::vector<std::string> paths;
  const auto add = [&](const Json& values) {
    for (const auto& [path, value] : values.items()) {
      if (std::ranges::find(paths, path) == paths.end()) paths.push_back(path);
    }
  };
  for (const Json& point : campaign.list) add(point);
  add(campaign.grid);
  return paths;
}

Json campaign_schema() {
  Campaign defaults;
  return file_schema("quicksand campaign", "Generated by `quicksand list campaign_schema`.",
                     [&](Fields& f) { describe_campaign(f, defaults); });
}

}  // namespace quicksand
