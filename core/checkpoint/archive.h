// How the structs of a checkpoint become CBOR: for those sources only that write into checkpoints.
#pragma once

#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace quicksand {

// One description of the format for both directions: describe(archive, object) names the fields of the object,
// which the archive writes, or reads where its JSON is constant.
template <class Json>
class CheckpointArchive {
 public:
  explicit CheckpointArchive(Json& json) : json_(json) {}

  template <class T>
  void value(const char* key, T& x) {
    if constexpr (kReads)
      json_.at(key).get_to(x);
    else
      json_[key] = x;
  }
  // A value that earlier versions of the format do not have: who reads one of these keeps its own.
  template <class T>
  void added(const char* key, T& x) {
    if (!kReads || json_.contains(key)) value(key, x);
  }
  // Whether to go on with a key that is absent where there is nothing to write.
  bool has(const char* key, bool written) const {
    if constexpr (kReads) return json_.contains(key);
    return written;
  }
  template <class E>
  void word(const char* key, E& x) {
    if constexpr (kReads) {
      const int number = json_.at(key).template get<int>();
      x = static_cast<E>(number);
      if (static_cast<int>(x) != number) fail(key, "is not a known word");
    } else {
      json_[key] = static_cast<int>(x);
    }
  }
  template <class Optional>
  void optional(const char* key, Optional& x) {
    if constexpr (!kReads)
      json_[key] = x ? nlohmann::json(*x) : nlohmann::json(nullptr);
    else if (json_.at(key).is_null())
      x.reset();
    else
      json_.at(key).get_to(x.emplace());
  }
  // The key itself is absent where there is none.
  template <class OptionalRandom>
  void optional_random(const char* key, OptionalRandom& x) {
    if constexpr (kReads) {
      if (json_.contains(key)) value(key, x.emplace().state);
    } else {
      if (x) value(key, x->state);
    }
  }
  // Plain arrays of doubles, Vec2, Vec3 or one-byte values, as raw bytes.
  template <class Items>
  void array(const char* key, Items& items) {
    using T = typename Items::value_type;
    if constexpr (kReads) {
      const auto& bytes = json_.at(key).get_binary();
      if (bytes.size() % sizeof(T) != 0) fail(key, "is cut short");
      items.resize(bytes.size() / sizeof(T));
      if (!bytes.empty()) std::memcpy(static_cast<void*>(items.data()), bytes.data(), bytes.size());
    } else {
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(items.data());
      json_[key] = nlohmann::json::binary({bytes, bytes + items.size() * sizeof(T)});
    }
  }
  // A plain struct of doubles, as an array of at most one.
  template <class Optional>
  void optional_array(const char* key, Optional& x) {
    std::vector<typename Optional::value_type> items;
    if constexpr (!kReads)
      if (x) items.push_back(*x);
    array(key, items);
    if constexpr (kReads) {
      if (items.size() > 1) fail(key, "is too long");
      if (!items.empty()) x = items.front();
    }
  }
  template <class F>
  void object(const char* key, F describe) {
    CheckpointArchive inner(json_for(key, nlohmann::json::object()));
    describe(inner);
  }
  // Few structs; `describe(archive, item)` visits one.
  template <class Items, class F>
  void list(const char* key, Items& items, F describe) {
    Json& entries = json_for(key, nlohmann::json(items.size(), nlohmann::json::object()));
    if constexpr (kReads) {
      if (!entries.is_array()) fail(key, "is not a list");
      items.assign(entries.size(), {});
    }
    for (std::size_t k = 0; k < items.size(); ++k) {
      CheckpointArchive entry(entries[k]);
      describe(entry, items[k]);
    }
  }
  // Many structs, as one array a member, without padding: `describe` calls its argument with the key of each member
  // and a pointer to it, or a function that refers to it.
  template <class Items, class F>
  void columns(const char* key, Items& items, F describe) {
    object(key, [&](CheckpointArchive& arrays) {
      bool first = true;
      describe([&](const char* name, auto member) {
        using Member = std::remove_cvref_t<decltype(std::invoke(member, items[0]))>;
        // Words and flags are bytes.
        std::vector<std::conditional_t<sizeof(Member) == 1, std::uint8_t, Member>> values;
        if constexpr (!kReads)
          for (const auto& item : items)
            values.push_back(
                static_cast<typename decltype(values)::value_type>(std::invoke(member, item)));
        arrays.array(name, values);
        if constexpr (kReads) {
          if (std::exchange(first, false)) items.assign(values.size(), {});
          if (values.size() != items.size()) fail(key, "has arrays that differ in length");
          for (std::size_t k = 0; k < items.size(); ++k)
            std::invoke(member, items[k]) = static_cast<Member>(values[k]);
        }
      });
    });
  }

 private:
  static constexpr bool kReads = std::is_const_v<Json>;

  Json& json_for(const char* key, [[maybe_unused]] const nlohmann::json& fresh) {
    if constexpr (kReads)
      return json_.at(key);
    else
      return json_[key] = fresh;
  }
  [[noreturn]] static void fail(const char* key, const char* problem) {
    throw std::runtime_error(std::string(key) + " " + problem);
  }

  Json& json_;
};

using CheckpointWriter = CheckpointArchive<nlohmann::json>;
using CheckpointReader = CheckpointArchive<const nlohmann::json>;

}  // namespace quicksand
