// Reads the fields of an object from JSON, strictly: a value of the wrong type or out of its range,
// a missing required key and an unknown key are refused with an InputError that says where, what,
// the allowed range with its unit and the nearest valid name.
#pragma once

#include <string>
#include <vector>

#include "app/json/fields.h"
#include "app/json/json_text.h"

namespace quicksand {

class JsonReader : public Fields {
 public:
  // `path` is the place of `value` inside the file, "" for the whole, which messages call `whole`.
  // Throws InputError if it is not an object.
  JsonReader(const Json& value, std::string path, std::string whole = "a scene");

  // After the visit: throws InputError if a key was not asked for.
  void refuse_unknown_keys() const;

  void number(const Field& field, const Limits& limits, double& value) override;
  void number(const Field& field, const Limits& limits, std::optional<double>& value) override;
  void vector(const Field& field, const Limits& limits, Vec2& value) override;
  void vector(const Field& field, const Limits& limits, std::optional<Vec2>& value) override;
  void numbers(const Field& field, const Limits& limits, std::size_t most,
               std::vector<double>& values) override;
  void integer(const Field& field, std::int64_t low, std::int64_t high,
               std::int64_t& value) override;
  void flag(const Field& field, bool& value) override;
  void text(const Field& field, std::string& value) override;
  void word(const Field& field, std::span<const std::string_view> words, int& value) override;
  void json(const Field& field, const Shape& shape, Json& value) override;
  void object(const Field& field, const Visit& visit) override;
  void exactly_one(const std::vector<std::string>& names) override;
  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override;
  void refuse(const char* name, const std::string& problem) override;
  bool reading() const override { return true; }

 protected:
  bool begin_optional(const Field& field, bool present, const Visit& visit) override;
  void items(const Field& field, std::size_t most, std::size_t size,
             const std::function<void(std::size_t)>& resize, const VisitItem& visit) override;

 private:
  // The value of a key, or null if it is absent; throws if it is required.
  const Json* find(const Field& field);
  std::string place(std::string_view name) const;

  const Json* object_;
  std::string path_;
  std::string whole_;
  std::vector<std::string> known_;  // keys that were asked for
};

// The name of a value's type with the value itself if it is short: `the text "big"`.
std::string described(const Json& value);

// The range in words: "a number above 0 and at most 1e+06 [d]".
std::string described(const Limits& limits);

// Shortest text that reads back as the same number.
std::string number_text(double value);

}  // namespace quicksand
