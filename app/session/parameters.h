// The parameters of a scene as a panel shows them: with unit, range and meaning from the description of
// the scene format, and whether the scene models them.
#pragma once

#include <string>
#include <vector>

#include "app/json/json_text.h"
#include "core/scene/scenario.h"

namespace quicksand {

struct Parameter {
  enum class Kind : std::uint8_t { number, integer, flag, word };

  std::string path;   // "contact.friction", "phases[1].force"
  std::string label;  // "friction"
  std::string help;
  std::string unit;  // "1" if none
  Kind kind = Kind::number;
  double low = 0, high = 0;        // of numbers and integers [unit]
  bool above_low = false;          // low itself is not admissible
  std::vector<std::string> words;  // of a word
  Json value;                      // null: the scene does not model it
};

// Those that a panel offers, grouped in a fixed order; values in grain units, as in the resolved scene.
struct ParameterGroup {
  std::string name;  // "Contacts"
  std::vector<Parameter> parameters;
};
std::vector<ParameterGroup> parameters_of(const Scenario& scenario);

}  // namespace quicksand
