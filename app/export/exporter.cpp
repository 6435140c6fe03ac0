#include "app/export/exporter.h"

#include <algorithm>
#include <sstream>

#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace fs = std::filesystem;

Exporter::Exporter(const ExportFormat& format, fs::path out, std::size_t states)
    : format_(format), out_(std::move(out)), states_(states), files_(tables().size()) {
  if (!format_.one_file) {
    make_writable({out_});
    return;
  }
  if (fs::is_directory(out_)) {
    throw InputError(out_.string(), "is a folder; " + std::string(format_.word) +
                                        " is one file, to be named with --out");
  }
  if (out_.has_parent_path()) make_writable({out_.parent_path()});
  single_ = std::make_unique<WholeFile>(out_);
}

std::string Exporter::file_name(const DataTable& table) const {
  std::string name(table.name);
  if (states_ > 1) {
    constexpr std::size_t kDigits = 4;
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
    file.finish();
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
    write_whole(out_ / (std::string(tables()[i].name) + ".pvd"), format_.collection(files_[i]));
}

void export_state(const World& world, const ExportFormat& format, const fs::path& out) {
  Exporter exporter(format, out, 1);
  exporter.add(world);
  exporter.finish();
}

}  // namespace quicksand
