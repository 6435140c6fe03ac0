// quicksand export: what is in the files is what is in the world.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "app/export/exporter.h"
#include "core/base/errors.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/shapes/intruder_shapes.h"
#include "core/world/shaped_contact.h"
#include "tests/support/files.h"
#include "tests/support/pierced_scene.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const std::string kState = "out/pierced/state.cbor";

class ExportTest : public ProgramFixture {
 protected:
  World run_scene() const {
    folder_.write("pierced.json", kPiercedScene);
    EXPECT_EQ(quicksand({"run", "pierced.json", "--no-frames", "--set", "phases[0].grains=60",
                         "--set", "phases[1].max_time=0.5"})
                  .exit_code,
              0);
    return read_checkpoint(at(kState)).world;
  }
  void export_as(const std::string& format, const std::string& out) const {
    const Outcome outcome = quicksand({"export", kState, "--format", format, "--out", out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, out + "\n");
  }
  // Runs a script that compares files with the CSV files; skips where its library is missing.
  void read_with_python(const std::string& what) const {
    const fs::path log = at("python.log");
    const std::string command = "cd '" + folder_.path().string() + "' && /usr/bin/python3 '" +
                                (kSource / "tests/app/export/export_readers.py").string() + "' " +
                                what + " > '" + log.string() + "' 2>&1";
    constexpr int kMissing = 77;
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kMissing || WEXITSTATUS(status) == 127)
      GTEST_SKIP() << contents(log);
    EXPECT_EQ(WEXITSTATUS(status), 0) << contents(log);
  }
};

using CsvColumns = std::map<std::string, std::vector<double>>;

CsvColumns read_csv(const fs::path& file) {
  std::istringstream text(contents(file));
  std::vector<std::string> names;
  CsvColumns columns;
  for (std::string line, cell; std::getline(text, line);) {
    std::istringstream cells(line);
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (columns.size() <= i && names.size() <= i) {
        names.push_back(cell);
      } else {
        columns[names[i]].push_back(std::stod(cell));
      }
    }
  }
  return columns;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST_F(ExportTest, TablesHoldTheWorldBitByBit) {
  const World world = run_scene();
  export_as("csv", "csv");
  const CsvColumns disks = read_csv(at("csv/disks.csv"));
  ASSERT_EQ(disks.at("radius").size(), 61U);
  for (std::size_t i = 0; i < 61; ++i) {
    const Disks& d = world.disks;
    EXPECT_TRUE(same_bits(disks.at("unwrapped_x")[i], d.position[i].x()));
    EXPECT_TRUE(same_bits(disks.at("position_y")[i], d.position[i].y()));
    EXPECT_TRUE(same_bits(disks.at("radius")[i], d.radius[i]));
    EXPECT_TRUE(same_bits(disks.at("velocity_x")[i], d.velocity[i].x()));
    EXPECT_TRUE(same_bits(disks.at("spin")[i], d.velocity[i].z()));
    EXPECT_TRUE(same_bits(disks.at("applied_force_y")[i], d.applied[i].y()));
    EXPECT_EQ(disks.at("role")[i] == 1, d.role[i] == DiskRole::intruder);
    EXPECT_GE(disks.at("position_x")[i], 0);
    EXPECT_LT(disks.at("position_x")[i], 12);
  }
  const CsvColumns contacts = read_csv(at("csv/contacts.csv"));
  EXPECT_EQ(std::ranges::count(contacts.at("bond"), 1.0), measure(world).bonds_active);
  EXPECT_EQ(std::ranges::count(contacts.at("touching"), 1.0), measure(world).contacts);
  const CsvColumns states = read_csv(at("csv/states.csv"));
  EXPECT_EQ(states.at("initial_bonds_active")[0] / states.at("initial_bonds")[0],
            measure(world).remaining_bond_fraction);
}

TEST_F(ExportTest, ForcesAreThoseOfTheLastStep) {
  const World world = run_scene();
  export_as("csv", "csv");
  const CsvColumns rows = read_csv(at("csv/contacts.csv"));
  std::size_t found = 0;
  for (std::size_t i = 0; i < rows.at("a").size(); ++i) {
    const double wall = rows.at("wall")[i];
    const Pair pair{static_cast<int>(rows.at("a")[i]),
                    static_cast<int>(wall < 0 ? rows.at("b")[i] : kWallBase + wall)};
    const auto contact = std::ranges::find(world.contacts, pair, &Contact::pair);
    const bool listed = contact != world.contacts.end();
    const Vec2 force = listed ? contact->force(world.impulse_dt) : Vec2(0, 0);
    EXPECT_TRUE(same_bits(rows.at("force_x")[i], force.x()));
    EXPECT_TRUE(same_bits(rows.at("force_y")[i], force.y()));
    const double along = listed ? force.dot(contact->normal) : 0;
    EXPECT_NEAR(rows.at("normal_force")[i], along, 1e-12 * (1 + force.norm()));
    found += force.norm() > 0 ? 1 : 0;
  }
  const auto loaded = std::ranges::count_if(world.contacts, [&](const Contact& contact) {
    return contact.force(world.impulse_dt).norm() > 0;
  });
  EXPECT_EQ(found, loaded) << "no contact with a force is left out";
}

TEST(Export, AContactThroughAPeriodicSideIsAShortLine) {
  Scenario scenario;
  scenario.box = {.width = 6, .height = 4};
  scenario.disks = {{.position = {0.25, 0.5}}, {.position = {5.25, 0.5}}};
  const World world = make_world(scenario);
  const TemporaryFolder folder;
  export_state(world, export_format("csv"), folder.path());
  const CsvColumns contacts = read_csv(folder.path() / "contacts.csv");
  ASSERT_EQ(contacts.at("a").size(), 3U) << "two on the floor, one with each other";
  EXPECT_EQ(contacts.at("a")[0], 0);
  EXPECT_EQ(contacts.at("b")[0], 1);
  EXPECT_EQ(contacts.at("branch_x")[0], -1);
  EXPECT_EQ(contacts.at("normal_x")[0], -1);
  EXPECT_EQ(contacts.at("b")[1], -1);
  EXPECT_EQ(contacts.at("wall")[1], 0);
  EXPECT_EQ(contacts.at("branch_y")[1], -0.5);
  EXPECT_EQ(contacts.at("force_y")[1], 0) << "no step was made";
}

TEST(Export, AWallIsALineAlongThePacking) {
  Scenario scenario;
  scenario.box = {.width = 6, .height = 4, .sides = Sides::walls};
  const World world = make_world(scenario);
  const ExportedWorld exported(world);
  EXPECT_EQ(exported.wall_end(0, 0), Vec2(6, 0));
  EXPECT_EQ(exported.wall_end(0, 1), Vec2(0, 0));
  EXPECT_EQ(exported.wall_end(2, 0), Vec2(6, 4));
  EXPECT_EQ(exported.wall_end(2, 1), Vec2(6, 0));
}

// A closed line around each part, in its area and at its rounding from the hull of its corners.
TEST(Export, OutlinesGoAroundTheParts) {
  Scenario scenario;
  scenario.box = {.width = 12, .height = 8};
  World world = make_world(scenario);
  const std::vector<ConvexPart> parts = parts_of(ConeIntruder{.width = 3, .length = 2});
  const int body = add_shape(world, {.position = {6, 5}}, parts);
  world.disks.angle[body] = 0.4;
  const TemporaryFolder folder;
  export_state(world, export_format("csv"), folder.path());
  const CsvColumns outlines = read_csv(folder.path() / "outlines.csv");
  ASSERT_EQ(outlines.at("body").front(), body);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    std::vector<Vec2> from, to;
    for (std::size_t i = 0; i < outlines.at("part").size(); ++i) {
      if (outlines.at("part")[i] != static_cast<double>(part)) continue;
      from.emplace_back(outlines.at("from_x")[i], outlines.at("from_y")[i]);
      to.emplace_back(outlines.at("to_x")[i], outlines.at("to_y")[i]);
    }
    ASSERT_GT(from.size(), 3U);
    double area = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      EXPECT_EQ(to[i], from[(i + 1) % from.size()]);
      area += (from[i].x() * to[i].y() - from[i].y() * to[i].x()) / 2;
      EXPECT_TRUE(holds(world, body, from[i] - 1e-9 * (from[i] - Vec2(6, 5))));
    }
    const double exact = mass_properties(std::span(parts).subspan(part, 1)).area;
    EXPECT_NEAR(area / exact, 1, 1e-4) << "a part of 48 pieces a turn";
    EXPECT_LT(area, exact);
  }
}

// Readers of XYZ know no shapes: points trace the outline, each with an id of its own and the number of its body.
TEST(Export, XyzTracesTheOutlineOfAShapedIntruder) {
  Scenario scenario;
  scenario.box = {.width = 12, .height = 10, .floor = true};
  scenario.disks = {{.position = {2, 0.5}}};
  World world = make_world(scenario);
  const std::vector<ConvexPart> parts{{.corners = {{-1.5, 0}, {1.5, 0}}, .radius = 0.25}};
  const int body = add_shape(world, {.position = {6, 5}, .role = DiskRole::intruder}, parts);
  const TemporaryFolder folder;
  export_state(world, export_format("xyz"), folder.path() / "plate.xyz");
  std::istringstream file(contents(folder.path() / "plate.xyz"));
  std::size_t count = 0;
  file >> count;
  std::string line;
  for (int head = 0; head < 2; ++head) std::getline(file, line);
  std::set<int> ids;
  while (std::getline(file, line)) {
    std::istringstream words(line.substr(2));
    int id = -1;
    double x = 0, y = 0;
    words >> id >> x >> y;
    EXPECT_TRUE(ids.insert(id).second) << id;
    EXPECT_TRUE(line.ends_with(line.starts_with("Si") ? " 0" : " " + std::to_string(body))) << line;
    if (!line.starts_with("O ")) continue;
    const double beside = std::max(std::abs(x - 6) - 1.5, 0.0);  // beyond the straight flanks
    EXPECT_NEAR(std::hypot(beside, y - 5), 0.25, 1e-3) << line;
  }
  EXPECT_EQ(ids.size(), count);
  const double outline = 2 * 3 + 2 * std::numbers::pi * 0.25;
  EXPECT_NEAR(static_cast<double>(count), 2 + outline / 0.1, 2);
}

TEST(Export, AnEmptyWorldIsExportedInAllFormats) {
  Scenario scenario;
  scenario.box = {.width = 0, .height = 0, .sides = Sides::open, .floor = false};
  const World world = make_world(scenario);
  const TemporaryFolder folder;
  for (const ExportFormat& format : export_formats()) {
    const fs::path out = folder.path() / (std::string(format.word) + std::string(format.extension));
    export_state(world, format, out);
    EXPECT_TRUE(fs::exists(format.one_file ? out : out / "states.csv"));
  }
}

// An .npy file must be readable by its published description alone.
TEST_F(ExportTest, NpyFilesAreAMagicTextAHeaderAndTheRows) {
  run_scene();
  export_as("npy", "npy");
  const std::string file = contents(at("npy/walls.npy"));
  ASSERT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  std::uint16_t length = 0;
  std::memcpy(&length, file.data() + 8, sizeof length);
  EXPECT_EQ((10 + length) % 64, 0);
  const std::string header = file.substr(10, length);
  EXPECT_EQ(header.substr(0, header.find("}") + 1),
            "{'descr': [('wall', '<i8'), ('point', '<f8', (2,)), ('normal', '<f8', (2,)), "
            "('velocity', '<f8', (2,)), ('mass', '<f8'), ('force', '<f8'), ('role', '<i8'), ], "
            "'fortran_order': False, 'shape': (1,), }");
  EXPECT_EQ(header.back(), '\n');
  constexpr std::size_t kRow = 10 * 8;
  ASSERT_EQ(file.size(), 10U + length + kRow);
  double up = 0;
  std::memcpy(&up, file.data() + 10 + length + 4 * 8, sizeof up);
  EXPECT_EQ(up, 1) << "the normal of the floor";
}

TEST_F(ExportTest, VtkFilesNameEveryColumnOnceAndTheirTime) {
  run_scene();
  export_as("vtk", "vtk");
  for (const DataTable& table : tables()) {
    const std::string text = contents(at("vtk/" + std::string(table.name) + ".vtp"));
    for (const DataColumn& column : table.columns) {
      if (table.corners == 1 && column.name == kPosition) continue;
      const std::string name = "Name=\"" + std::string(column.name) + "\"";
      EXPECT_NE(text.find(name), std::string::npos) << name;
      EXPECT_EQ(text.find(name), text.rfind(name)) << name;
    }
    EXPECT_NE(text.find("Name=\"TimeValue\""), std::string::npos);
    EXPECT_TRUE(text.ends_with("</VTKFile>\n"));
  }
  // Eight bytes of length, then the number of the only wall: sixteen zeros but for the length.
  const std::string walls = contents(at("vtk/walls.vtp"));
  EXPECT_NE(walls.find("Name=\"wall\" NumberOfComponents=\"1\" format=\"binary\">"
                       "CAAAAAAAAAAAAAAAAAAAAA==</DataArray>"),
            std::string::npos)
      << walls;
}

TEST_F(ExportTest, SeveralStatesAreNumberedOrFollowEachOther) {
  run_scene();
  const std::vector<std::string> states{"export", kState, kState, "--out"};
  const auto to = [&](const std::string& out, const std::string& format) {
    std::vector<std::string> arguments = states;
    arguments.insert(arguments.end(), {out, "--format", format});
    const Outcome outcome = quicksand(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  };
  to("vtk", "vtk");
  const std::string collection = contents(at("vtk/disks.pvd"));
  EXPECT_NE(collection.find("file=\"disks_0000.vtp\""), std::string::npos) << collection;
  EXPECT_NE(collection.find("file=\"disks_0001.vtp\""), std::string::npos) << collection;
  EXPECT_EQ(contents(at("vtk/disks_0000.vtp")), contents(at("vtk/disks_0001.vtp")));
  EXPECT_EQ(read_csv(at("vtk/states.csv")).at("time").size(), 2U);
  to("two.xyz", "xyz");
  export_as("xyz", "one.xyz");
  EXPECT_EQ(contents(at("two.xyz")), contents(at("one.xyz")) + contents(at("one.xyz")));
  to("csv", "csv");
  read_with_python("pvd");
}

TEST_F(ExportTest, AnExportLeavesNoFileOfAnEarlierOneWithMoreStates) {
  run_scene();
  const auto exported = [&](const std::vector<std::string>& states, const std::string& format) {
    std::vector<std::string> words{"export", "--format", format, "--out", "again"};
    words.insert(words.end(), states.begin(), states.end());
    EXPECT_EQ(quicksand(words).exit_code, 0);
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(at("again")))
      names.insert(entry.path().filename().string());
    return names;
  };
  const std::set<std::string> one = exported({kState}, "vtk");
  folder_.write("again/disks_of_mine.vtp", "");
  folder_.write("again/disks_0001.txt", "");
  std::set<std::string> with_mine = one;
  with_mine.insert({"disks_of_mine.vtp", "disks_0001.txt"});
  EXPECT_GT(exported({kState, kState, kState}, "vtk").size(), with_mine.size());
  EXPECT_EQ(exported({kState}, "vtk"), with_mine);
  EXPECT_GT(exported({kState}, "csv").size(), with_mine.size()) << "the other format stays";
}

TEST_F(ExportTest, DoesNotReplaceWhatItReads) {
  run_scene();
  for (const char* file : {"history.qsh", "state.cbor"}) {
    const std::string out = "out/pierced/" + std::string(file), before = contents(at(out));
    const Outcome outcome = quicksand({"export", "out/pierced", "--format", "xyz", "--out", out});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("is the input"), std::string::npos) << outcome.err;
    EXPECT_EQ(contents(at(out)), before);
  }
}

TEST_F(ExportTest, NumpyReadsWhatCsvSays) {
  run_scene();
  export_as("csv", "csv");
  export_as("npy", "npy");
  read_with_python("npy");
}

TEST_F(ExportTest, VtkReadsWhatCsvSays) {
  run_scene();
  export_as("csv", "csv");
  export_as("vtk", "vtk");
  read_with_python("vtk");
}

TEST_F(ExportTest, AseReadsWhatCsvSays) {
  run_scene();
  export_as("csv", "csv");
  export_as("xyz", "disks.xyz");
  read_with_python("xyz");
}

TEST_F(ExportTest, RefusesWhatItCannotExport) {
  run_scene();
  folder_.write("file", "");
  folder_.write("text.cbor", "not a checkpoint");
  fs::create_directory(at("folder"));
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"--format", "csv", "--out", "x"}, "states is required"},
      {{kState, "--out", "x"}, "--format is required"},
      {{kState, "--format", "csv"}, "--out is required"},
      {{kState, "--format", "cvs", "--out", "x"}, "did you mean \"csv\""},
      {{"nowhere.cbor", "--format", "csv", "--out", "x"}, "nowhere.cbor: cannot be read"},
      {{kState, "text.cbor", "--format", "xyz", "--out", "a.xyz"},
       "text.cbor: is not a complete checkpoint"},
      {{kState, "--format", "csv", "--out", "file"}, "file: is a file"},
      {{kState, "--format", "xyz", "--out", "folder"}, "folder: is a folder"},
  };
  for (const auto& [arguments, answer] : mistakes) {
    std::vector<std::string> all{"export"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = quicksand(all);
    EXPECT_EQ(outcome.exit_code, 2) << answer;
    EXPECT_NE(outcome.err.find(answer), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(fs::exists(at("a.xyz"))) << "a single file is there as a whole or not at all";
  EXPECT_FALSE(fs::exists(at("a.xyz.part")));
}

TEST_F(ExportTest, EveryColumnIsListedWithItsUnitAndMeaning) {
  const Outcome listed = quicksand({"list", "columns"});
  EXPECT_EQ(listed.exit_code, 0);
  for (const DataTable& table : tables()) {
    for (const DataColumn& column : table.columns) {
      EXPECT_FALSE(column.unit.empty()) << column.name;
      EXPECT_FALSE(column.help.empty()) << column.name;
      EXPECT_NE(listed.out.find("  " + std::string(column.name) + " "), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace quicksand::test
