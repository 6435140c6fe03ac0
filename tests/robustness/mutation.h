// Makes a text slightly wrong in ways that readers have been known to mind.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace quicksand::test {

class Mutation {
 public:
  Mutation(unsigned seed, std::vector<std::string> seeds);

  // A seed with one to eight changes: bytes, numbers, pieces of other seeds.
  std::string next();

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  void change_bytes(std::string& text);
  void change_number(std::string& text);
  void change_piece(std::string& text);

  std::mt19937 random_;
  std::vector<std::string> seeds_;
};

}  // namespace quicksand::test
