// What the program tells the shell.
#pragma once

namespace quicksand {

constexpr int kFine = 0;
constexpr int kRunFailed = 1;
constexpr int kBadInput = 2;
constexpr int kInterrupted = 130;

}  // namespace quicksand
