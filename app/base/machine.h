// What results were computed on.
#pragma once

#include <string>

namespace quicksand {

struct Machine {
  std::string processor;  // as the system names it
  int cores = 0;
  double load = 0;  // mean number of running processes over the last minute; our own is one
};
Machine machine();

}  // namespace quicksand
