#include "app/json/json_reader.h"

#include <algorithm>
#include <vector>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

constexpr std::size_t kMostMistakes = 10;  // that are told at once, of one list or object

// All as one: the first, with the others told after it.
[[noreturn]] void throw_together(const std::vector<InputError>& errors) {
  std::string told = errors.front().what();
  for (std::size_t k = 1; k < errors.size(); ++k)
    told += "\n  and " + errors[k].path() + ": " + errors[k].what();
  if (errors.size() == kMostMistakes) told += "\n  and there may be more";
  throw InputError(errors.front().path(), told, errors.front().nearest());
}

class JsonReader : public Fields {
 public:
  JsonReader(const Json& object, std::string path, std::string whole)
      : object_(&object), path_(std::move(path)), whole_(std::move(whole)) {}

  // After the visit: throws InputError if keys were not asked for.
  void refuse_unknown_keys() const {
    std::vector<InputError> errors;
    for (const auto& item : object_->items()) {
      const std::string& key = item.key();
      if (errors.size() == kMostMistakes) break;
      if (std::ranges::find(known_, key) != known_.end()) continue;
      collect(errors, [&] {
        refuse_name(place(shortened(key)),
                    "is not a key of " + (path_.empty() ? whole_ : "this object"), key, known_);
      });
    }
    if (!errors.empty()) throw_together(errors);
  }

  const std::vector<std::string>& known() const { return known_; }

  void exactly_one(const std::vector<std::string>& names) override {
    const std::string all = joined(names, " or ");
    std::vector<std::string> given;
    for (const std::string& name : names)
      if (object_->contains(name)) given.push_back(name);
    if (given.empty()) throw InputError(place(names.front()), "is missing; give " + all);
    if (given.size() > 1) {
      throw InputError(place(given[1]), "is given besides " + given[0] + "; give only one: " + all);
    }
  }

  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override {
    word({field.name, field.help, Presence::required}, words, index);
    visit(*this, index);
  }

  void refuse(const char* name, const std::string& problem, const std::string& nearest) override {
    throw InputError(place(name), problem, nearest);
  }
  bool reading() const override { return true; }

 protected:
  void leaf(const Field& field, const Leaf& leaf) override {
    if (const Json* found = find(field)) leaf.read(*found, place(field.name));
  }

  bool begin_optional(const Field& field, bool /*present*/, const Visit& visit) override {
    const Json* found = find(field);
    if (found != nullptr) read_fields(*found, {}, visit, place(field.name));
    return found != nullptr;
  }

  void items(const Field& field, std::size_t most, std::size_t /*size*/,
             const std::function<void(std::size_t)>& resize, const VisitItem& visit) override {
    const Json* found = find(field);
    if (found == nullptr) return;
    if (!found->is_array()) {
      throw InputError(place(field.name), "is " + described(*found) + ", must be a list [...]");
    }
    refuse_longer_list(*found, most, place(field.name));
    resize(found->size());
    std::vector<InputError> errors;  // of objects that do not depend on each other
    for (std::size_t i = 0; i < found->size() && errors.size() < kMostMistakes; ++i) {
      collect(errors, [&] {
        read_fields((*found)[i], {}, [&](Fields& f) { visit(f, i); },
                    place(field.name) + "[" + std::to_string(i) + "]");
      });
    }
    if (!errors.empty()) throw_together(errors);
  }

 private:
  template <class Read>
  static void collect(std::vector<InputError>& errors, Read read) {
    try {
      read();
    } catch (const InputError& error) {
      errors.push_back(error);
    }
  }

  // The value of a key, or null if it is absent; throws if it is required.
  const Json* find(const Field& field) {
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

  std::string place(std::string_view name) const {
    return path_.empty() ? std::string(name) : path_ + "." + std::string(name);
  }

  const Json* object_;
  std::string path_;
  std::string whole_;
  std::vector<std::string> known_;  // keys that were asked for
};

// The first keys that an object may have, up to one that it must have.
std::vector<std::string> first_keys(const Fields::Visit& describe) {
  const Json nothing = Json::object();
  JsonReader reader(nothing, {}, {});
  try {
    describe(reader);
  } catch (const InputError&) {  // it misses a key
  }
  constexpr std::size_t kMost = 4;
  std::vector<std::string> keys = reader.known();
  keys.resize(std::min(kMost, keys.size()));
  return keys;
}

}  // namespace

void read_fields(const Json& json, const std::string& whole, const Fields::Visit& describe,
                 const std::string& path) {
  if (!json.is_object()) {
    const std::vector<std::string> keys = first_keys(describe);
    throw InputError(path, "is " + described(json) + ", must be an object {...}" +
                               (keys.empty() ? "" : " with keys such as " + joined(keys, ", ")));
  }
  JsonReader reader(json, path, whole);
  describe(reader);
  reader.refuse_unknown_keys();
}

}  // namespace quicksand
