// The states that a run passed through, as history.qsh keeps them: opened, listed by moments, read one by one.
// The run may still be computing, in another process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/history/record.h"
#include "core/base/whole_file.h"
#include "core/world/world.h"

namespace quicksand {

class History {
 public:
  // Throws InputError, with the file and the place in it, if it is missing, damaged or of another version.
  explicit History(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  // Of the records, in their order; times never decrease. A record that is not yet written to its end is left out.
  const std::vector<Moment>& moments() const { return moments_; }
  // Whether the file goes on behind the last whole record: another is being written, or was when the file was cut short.
  bool ends_within_record() const;
  // Takes over what the run has added or thinned out since; true if something changed. A run that began again in this
  // folder is taken over with its first record. Throws InputError; what was listed then stays.
  bool refresh();
  // How often the file has turned out to be another one, of a run that began again or whose records were thinned out.
  int replacements() const { return replacements_; }
  // The moment nearest to a time; of equal times the last, after all that happened then. There must be one.
  std::size_t nearest(double time) const;
  // Throws InputError if the record is damaged, NotEnoughMemory if there is too little to read it.
  World world(std::size_t k) const;

 private:
  struct Place {
    std::uint64_t offset;  // of the record's head
    RecordHead head;
  };
  void scan();
  bool replaced() const;
  [[noreturn]] void fail(std::uint64_t offset, const std::string& problem) const;

  std::filesystem::path path_;
  OpenFile file_;
  std::uint64_t end_ = 0;  // of the last whole record
  std::vector<Place> places_;
  std::vector<Moment> moments_;
  int replacements_ = 0;
};

}  // namespace quicksand
