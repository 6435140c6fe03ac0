// Samples that are kept evenly, however many there are.
#pragma once

#include <utility>
#include <vector>

namespace quicksand {

// Keeps the first, third, fifth, ... of them.
template <class T>
void keep_every_second(std::vector<T>& samples) {
  // From 1 on: what is moved onto itself may lose its contents.
  for (std::size_t i = 1; 2 * i < samples.size(); ++i) samples[i] = std::move(samples[2 * i]);
  samples.resize((samples.size() + 1) / 2);
}

}  // namespace quicksand
