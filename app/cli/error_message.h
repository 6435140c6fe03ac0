// What the program says when it fails: a text for people, or a line of JSON for a program that called it
// (QUICKSAND_MESSAGES=json).
#pragma once

#include <string>

#include "core/base/errors.h"

namespace quicksand {

// A failure that is not the fault of an input.
struct FailureMessage {
  std::string kind;     // run_failed, scene, session, validation, disk_full, memory or unexpected
  std::string message;  // a sentence
  std::string how_to_go_on;  // further lines
};

// Both print to standard error and return the exit code.
int tell_error(const InputError& error);
int tell_failed(const FailureMessage& failure);

}  // namespace quicksand
