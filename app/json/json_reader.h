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

  void exactly_one(const std::vector<std::string>& names) override;
  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override;
  void refuse(const char* name, const std::string& problem) override;
  bool reading() const override { return true; }

 protected:
  void leaf(const Field& field, const Leaf& leaf) override;
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

// All fields of an object that is the whole of `whole`, "a scene". Throws InputError.
void read_fields(const Json& json, const std::string& whole, const Fields::Visit& describe);

}  // namespace quicksand
