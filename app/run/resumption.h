// What can be done with the folder of a run that ended somehow: by itself, by Ctrl-C, or in the middle.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/run/run_position.h"
#include "app/run_folder/run_folder.h"

namespace quicksand {

struct Resumption {
  enum class How : std::uint8_t {
    finished,      // nothing is left to do
    goes_on,       // from its state
    starts_again,  // its results do not reach as far as its state, or there is none
  };
  How how = How::goes_on;
  std::string why;  // it starts again: a phrase
};

// The first frame of so many rows that is not there as a whole; whether the rows of a position are not as they
// were written. Both throw InputError where a file is there and cannot be read.
std::optional<std::filesystem::path> missing_frame(const RunFolder& folder, std::int64_t rows);
bool lacks_rows(const RunFolder& folder, const RunPosition& position);

// `frames`: whether the run draws pictures. Throws InputError if the state is of another format version: the program that
// wrote it can go on with it; and if a file is there and cannot be read. NotEnoughMemory where there is too little to
// read the state.
Resumption resumption_of(const RunFolder& folder, bool frames);

}  // namespace quicksand
