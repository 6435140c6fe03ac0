#include "app/json/json_reader.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

// What is wrong with a file, told at once. What follows from other values may follow from one that is wrong, so it is told
// only where nothing else is.
class Mistakes {
 public:
  bool full() const { return own_.size() == kMost; }
  std::size_t count() const { return own_.size() + following_.size(); }
  void add(const InputError& error) {
    if (!full()) own_.push_back(error);
  }
  void add_following(const InputError& error) {
    if (following_.size() < kMost) following_.push_back(error);
  }
  // The first, with the others told after it.
  void throw_if_any() const {
    const std::vector<InputError>& errors = own_.empty() ? following_ : own_;
    if (errors.empty()) return;
    std::string told = errors.front().what();
    for (std::size_t k = 1; k < errors.size(); ++k)
      told += "\n  and " + errors[k].path() + ": " + errors[k].what();
    if (errors.size() == kMost) told += "\n  and there may be more";
    throw InputError(errors.front().path(), told, errors.front().nearest());
  }

 private:
  static constexpr std::size_t kMost = 10;
  std::vector<InputError> own_, following_;
};

// Thrown where the rest of an object cannot be read, after the mistake has been noted.
struct Unreadable {};

void read_object(const Json& json, const std::string& whole, const Fields::Visit& describe,
                 const std::string& path, Mistakes& mistakes);

class JsonReader : public Fields {
 public:
  JsonReader(const Json& object, std::string path, std::string whole, Mistakes& mistakes)
      : object_(&object), path_(std::move(path)), whole_(std::move(whole)), mistakes_(&mistakes) {}

  // After the visit: keys that were not asked for.
  void refuse_unknown_keys() const {
    for (const auto& item : object_->items()) {
      const std::string& key = item.key();
      const auto is_in = [&](const std::vector<std::string>& names) {
        return std::ranges::find(names, key) != names.end();
      };
      if (is_in(known_) || is_in(misspelt_)) continue;
      note([&] {
        refuse_name(place(shortened(key)),
                    "is not a key of " + (path_.empty() ? whole_ : "this object"), key, known_);
      });
    }
  }

  // The keys that were asked for, up to one that must be there and is not.
  std::vector<std::string> first_known() const {
    return {known_.begin(),
            known_.begin() + static_cast<std::ptrdiff_t>(first_missing_.value_or(known_.size()))};
  }

  void exactly_one(const std::vector<std::string>& names) override {
    const std::string all = joined(names, " or ");
    std::vector<std::string> given;
    for (const std::string& name : names)
      if (object_->contains(name)) given.push_back(name);
    if (given.empty()) add(names.front(), "is missing; give " + all);
    if (given.size() > 1) {
      add(given[1], "is given besides " + given[0] + "; give only one: " + all);
    }
    if (given.size() != 1) throw Unreadable();
  }

  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override {
    const std::size_t before = mistakes_->count();
    word({field.name, field.help, Presence::required}, words, index);
    if (mistakes_->count() > before) throw Unreadable();
    visit(*this, index);
  }

  void refuse(const char* name, const std::string& problem, const std::string& nearest) override {
    mistakes_->add_following(InputError(place(name), problem, nearest));
    throw Unreadable();
  }
  bool reading() const override { return true; }

 protected:
  void leaf(const Field& field, const Leaf& leaf) override {
    if (const Json* found = find(field)) note([&] { leaf.read(*found, place(field.name)); });
  }

  bool begin_optional(const Field& field, bool /*present*/, const Visit& visit) override {
    const Json* found = find(field);
    if (found != nullptr) read_object(*found, {}, visit, place(field.name), *mistakes_);
    return found != nullptr;
  }

  void items(const Field& field, std::size_t most, std::size_t /*size*/,
             const std::function<void(std::size_t)>& resize, const VisitItem& visit) override {
    const Json* found = find(field);
    if (found == nullptr) return;
    if (!found->is_array()) {
      add(field.name, "is " + described(*found) + ", must be a list [...]");
      return;
    }
    const std::size_t before = mistakes_->count();
    note([&] { refuse_longer_list(*found, most, place(field.name)); });
    if (mistakes_->count() > before) return;
    resize(found->size());
    for (std::size_t i = 0; i < found->size() && !mistakes_->full(); ++i)
      read_object((*found)[i], {}, [&](Fields& f) { visit(f, i); },
                  place(field.name) + "[" + std::to_string(i) + "]", *mistakes_);
  }

 private:
  template <class Read>
  void note(Read read) const {
    try {
      read();
    } catch (const InputError& error) {
      mistakes_->add(error);
    }
  }
  void add(std::string_view name, const std::string& problem,
           const std::string& nearest = {}) const {
    mistakes_->add(InputError(place(name), problem, nearest));
  }

  // The value of a key, or null if it is absent, which is a mistake if it is required.
  const Json* find(const Field& field) {
    known_.emplace_back(field.name);
    const auto found = object_->find(field.name);
    if (found != object_->end()) return &*found;
    if (field.presence == Presence::required) {
      // A misspelt key is the likely reason for a missing one.
      std::vector<std::string> given;
      for (const auto& [key, value] : object_->items()) given.push_back(key);
      const std::string near = nearest_name(field.name, given);
      add(field.name,
          "is missing; it is required: " + std::string(field.help) +
              (near.empty() ? "" : " (you wrote \"" + near + "\")"),
          near.empty() ? near : std::string(field.name));
      misspelt_.push_back(near);
      if (!first_missing_) first_missing_ = known_.size();
    }
    return nullptr;
  }

  std::string place(std::string_view name) const {
    return path_.empty() ? std::string(name) : path_ + "." + std::string(name);
  }

  const Json* object_;
  std::string path_;
  std::string whole_;
  Mistakes* mistakes_;
  std::vector<std::string> known_;            // keys that were asked for
  std::vector<std::string> misspelt_;         // told with the missing key that they stand for
  std::optional<std::size_t> first_missing_;  // place in known_ after it
};

// The first keys that an object may have, up to one that it must have.
std::vector<std::string> first_keys(const Fields::Visit& describe) {
  const Json nothing = Json::object();
  Mistakes unheard;
  JsonReader reader(nothing, {}, {}, unheard);
  try {
    describe(reader);
  } catch (const Unreadable&) {  // it misses a key that says what the others are
  } catch (const InputError&) {
  }
  constexpr std::size_t kMost = 4;
  std::vector<std::string> keys = reader.first_known();
  keys.resize(std::min(kMost, keys.size()));
  return keys;
}

void read_object(const Json& json, const std::string& whole, const Fields::Visit& describe,
                 const std::string& path, Mistakes& mistakes) {
  if (!json.is_object()) {
    const std::vector<std::string> keys = first_keys(describe);
    mistakes.add(
        InputError(path, "is " + described(json) + ", must be an object {...}" +
                             (keys.empty() ? "" : " with keys such as " + joined(keys, ", "))));
    return;
  }
  JsonReader reader(json, path, whole, mistakes);
  try {
    describe(reader);
  } catch (const Unreadable&) {
    return;
  } catch (const InputError& error) {
    mistakes.add_following(error);
    return;
  }
  reader.refuse_unknown_keys();
}

}  // namespace

void read_fields(const Json& json, const std::string& whole, const Fields::Visit& describe,
                 const std::string& path) {
  Mistakes mistakes;
  read_object(json, whole, describe, path, mistakes);
  mistakes.throw_if_any();
}

}  // namespace quicksand
