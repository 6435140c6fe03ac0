#include "app/export/exporter.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigits = 4;  // of the number of a state, at least
constexpr std::string_view kCollection = ".pvd";

}  // namespace

Exporter::Exporter(const ExportFormat& format, fs::path out, std::size_t states)
    : format_(format), out_(std::move(out)), states_(states), files_(tables().size()) {
  if (!format_.one_file) {
    make_writable({out_});
    remove_earlier_tables();
    return;
  }
  if (fs::is_directory(out_)) {
    throw InputError(out_.string(), "is a folder; " + std::string(format_.word) +
                                        " is a single file; name it with --out");
  }
  if (out_.has_parent_path()) make_writable({out_.parent_path()});
  single_ = std::make_unique<WholeFile>(out_);
}

// Those of another number of states would pass for some of these.
void Exporter::remove_earlier_tables() const {
  std::vector<fs::path> earlier;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(out_, error)) {
    if (!entry.is_regular_file(error)) continue;
    const std::string name = entry.path().filename().string();
    for (const DataTable& table : tables()) {
      if (!name.starts_with(table.name)) continue;
      const std::string_view rest = std::string_view(name).substr(table.name.size());
      const std::size_t end = rest.starts_with('_') ? rest.find_first_not_of("0123456789", 1) : 0;
      const bool numbered = end == 0 || end > kDigits;
      const bool is_table =
          end != std::string_view::npos && numbered && rest.substr(end) == format_.extension;
      if (is_table || (format_.collection != nullptr && rest == kCollection))
        earlier.push_back(entry.path());
    }
  }
  for (const fs::path& file : earlier)
    if (!fs::remove(file, error))
      throw InputError(file.string(), "cannot be replaced: " + error.message());
}

std::string Exporter::file_name(const DataTable& table) const {
  std::string name(table.name);
  if (states_ > 1) {
    const std::string number = std::to_string(added_);
    const std::size_t digits = std::max(kDigits, std::to_string(states_ - 1).size());
    name += "_" + std::string(digits - number.size(), '0') + number;
  }
  return name + std::string(format_.extension);
}

void Exporter::add(const World& world) {
  const ExportedWorld exported(world);
  if (single_) return format_.write(single_->stream(), exported, disk_table());
  for (std::size_t i = 0; i < tables().size(); ++i) {
    const std::string name = file_name(tables()[i]);
    WholeFile file(out_ / name);
    format_.write(file.stream(), exported, tables()[i]);
    file.finish_soon();
    files_[i].push_back({name, world.time});
  }
  std::ostringstream state;
  write_csv(state, exported, state_table());
  const std::string text = state.str();
  rows_ += added_ == 0 ? text : text.substr(text.find('\n') + 1);
  ++added_;
}

void Exporter::finish() {
  if (single_) return single_->finish();
  write_whole(out_ / "states.csv", rows_);
  if (format_.collection == nullptr || states_ == 1) return;
  for (std::size_t i = 0; i < tables().size(); ++i)
    write_whole(out_ / (std::string(tables()[i].name) + std::string(kCollection)),
                format_.collection(files_[i]));
}

void export_state(const World& world, const ExportFormat& format, const fs::path& out) {
  Exporter exporter(format, out, 1);
  exporter.add(world);
  exporter.finish();
}

}  // namespace quicksand
