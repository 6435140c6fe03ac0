#include "app/json/json_reader.h"

#include <algorithm>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"

namespace quicksand {

JsonReader::JsonReader(const Json& value, std::string path, std::string whole)
    : object_(&value), path_(std::move(path)), whole_(std::move(whole)) {
  if (!value.is_object()) {
    throw InputError(path_, "is " + described(value) + ", must be an object {...}");
  }
}

void JsonReader::refuse_unknown_keys() const {
  for (const auto& [key, value] : object_->items()) {
    if (std::ranges::find(known_, key) == known_.end()) {
      refuse_name(place(key), "is not a key of " + (path_.empty() ? whole_ : "this object"), key,
                  known_);
    }
  }
}

const Json* JsonReader::find(const Field& field) {
  known_.emplace_back(field.name);
  const auto found = object_->find(field.name);
  if (found != object_->end()) return &*found;
  if (field.presence == Presence::required) {
    // A misspelt key is the likely reason for a missing one.
    std::vector<std::string> given;
    for (const auto& [key, value] : object_->items()) given.push_back(key);
    const std::string near = nearest_name(field.name, given);
    throw InputError(place(field.name),
                     "is missing; it is required: " + std::string(field.help) +
                         (near.empty() ? "" : " (you wrote \"" + near + "\")"),
                     near.empty() ? near : std::string(field.name));
  }
  return nullptr;
}

std::string JsonReader::place(std::string_view name) const {
  return path_.empty() ? std::string(name) : path_ + "." + std::string(name);
}

void JsonReader::leaf(const Field& field, const Leaf& leaf) {
  if (const Json* found = find(field)) leaf.read(*found, place(field.name));
}

bool JsonReader::begin_optional(const Field& field, bool /*present*/, const Visit& visit) {
  const Json* found = find(field);
  if (found == nullptr) return false;
  JsonReader inner(*found, place(field.name));
  visit(inner);
  inner.refuse_unknown_keys();
  return true;
}

void JsonReader::items(const Field& field, std::size_t most, std::size_t /*size*/,
                       const std::function<void(std::size_t)>& resize, const VisitItem& visit) {
  const Json* found = find(field);
  if (found == nullptr) return;
  if (!found->is_array()) {
    throw InputError(place(field.name), "is " + described(*found) + ", must be a list [...]");
  }
  refuse_longer_list(*found, most, place(field.name));
  resize(found->size());
  for (std::size_t i = 0; i < found->size(); ++i) {
    JsonReader inner((*found)[i], place(field.name) + "[" + std::to_string(i) + "]");
    visit(inner, i);
    inner.refuse_unknown_keys();
  }
}

void JsonReader::exactly_one(const std::vector<std::string>& names) {
  std::string all;
  std::vector<std::string> given;
  for (const std::string& name : names) {
    all += (all.empty() ? "" : " or ") + name;
    if (object_->contains(name)) given.push_back(name);
  }
  if (given.empty()) throw InputError(place(names.front()), "is missing; give " + all);
  if (given.size() > 1) {
    throw InputError(place(given[1]), "is given besides " + given[0] + "; give only one: " + all);
  }
}

void JsonReader::variant(const Field& field, std::span<const std::string_view> words, int index,
                         const std::function<void(Fields&, int)>& visit) {
  word({field.name, field.help, Presence::required}, words, index);
  visit(*this, index);
}

void JsonReader::refuse(const char* name, const std::string& problem) {
  throw InputError(place(name), problem);
}

void read_fields(const Json& json, const std::string& whole, const Fields::Visit& describe) {
  JsonReader reader(json, "", whole);
  describe(reader);
  reader.refuse_unknown_keys();
}

}  // namespace quicksand
