// Writes what libFuzzer starts from: `quicksand_fuzz_seeds DIR` makes DIR/READER/ with inputs that are read
// well, and DIR/READER.dict with the words of their formats and numbers that readers have been known to mind.
#include <fstream>
#include <set>

#include "app/campaign/campaign.h"
#include "app/commands/command_table.h"
#include "app/scene_json/scenario_json.h"
#include "tests/robustness/readers.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNumbers[] = {
    "-1",   "1e308", "-1e308", "1e-308", "2147483648", "1000000", "9007199254740993",    "1e12",
    "null", "[]",    "{}",     "[1,2]",  "true",       "\\u0000", "18446744073709551616"};

// Names and words in a schema or in an example.
void add_words(const Json& json, std::set<std::string>& words) {
  if (json.is_string()) words.insert(json.get<std::string>());
  if (json.is_object())
    for (const auto& [key, value] : json.items()) words.insert(key);
  if (json.is_structured())
    for (const Json& value : json) add_words(value, words);
}

// Help texts are words of the schema, not of the format.
bool is_name(const std::string& word) {
  return !word.empty() && word.size() < 40 && word.find(' ') == std::string::npos;
}

std::string escaped(const std::string& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += std::string("\\x") + kDigits[byte >> 4U] + kDigits[byte & 15U];
  }
  return text;
}

// As they stand in the files: in quotes in JSON, after their length in CBOR.
std::string dictionary(const Reader& reader) {
  std::set<std::string> words;
  const bool cbor = reader.name == "checkpoint";
  for (const std::string& seed : reader.seeds)
    add_words(cbor ? Json::from_cbor(seed) : parse_json(seed), words);
  if (reader.name == "scene" || reader.name == "campaign") add_words(scene_schema(), words);
  if (reader.name == "campaign") add_words(campaign_schema(), words);
  if (reader.name == "session" || reader.name == "line") add_words(session_schema(), words);
  std::string text;
  const auto add = [&](const std::string& bytes) { text += '"' + escaped(bytes) + "\"\n"; };
  for (const std::string& word : words) {
    if (!is_name(word)) continue;
    const std::vector<std::uint8_t> bytes = Json::to_cbor(word);
    add(cbor ? std::string(bytes.begin(), bytes.end()) : Json(word).dump());
  }
  if (!cbor)
    for (const char* number : kNumbers) add(number);
  return text;
}

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace
}  // namespace quicksand::test

int main(int argc, char** argv) {
  using namespace quicksand::test;
  if (argc != 2) return 2;
  const fs::path out = argv[1];
  const TemporaryFolder folder;
  for (const Reader& reader : readers(folder.path())) {
    fs::create_directories(out / reader.name);
    for (std::size_t k = 0; k < reader.seeds.size(); ++k)
      write(out / reader.name / ("seed_" + std::to_string(k)), reader.seeds[k]);
    write(out / (std::string(reader.name) + ".dict"), dictionary(reader));
  }
}
