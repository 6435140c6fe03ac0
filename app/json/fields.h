// The language in which a file format is described once: a function visits the fields of a struct
// with a Fields, and the same visit reads a file (json_reader), writes one (json_writer) or makes
// the schema (json_schema).
//
// The default of an optional field is what the struct holds before the visit. A kind of value is one function in
// fields.cpp, which says how it is read, written and described; visitors know only where it stands.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/json/json_text.h"
#include "core/base/types.h"

namespace quicksand {

enum class Presence : std::uint8_t { optional, required };

struct Field {
  const char* name;
  const char* help;  // what it is, for the schema
  Presence presence = Presence::optional;
};

// Admissible numbers, both ends included unless `above` is set, which leaves out `low`.
struct Limits {
  const char* unit;  // "d", "F_g", ...; "1" if none
  double low;        // [unit]
  double high;       // [unit]
  bool above = false;
  double scale = 1;  // value in the program over value in the file; a power of two, so that writing
                     // and reading give back the same bits
};
constexpr Limits above(double low, double high, const char* unit, double scale = 1) {
  return {unit, low, high, true, scale};
}
constexpr Limits between(double low, double high, const char* unit, double scale = 1) {
  return {unit, low, high, false, scale};
}

// What a value looks like that is kept as the JSON it is.
struct Shape {
  const char* words;  // "a list of texts"
  bool (*fits)(const Json& value);
  Json (*schema)();  // its type in a JSON Schema
};

// What visitors do with a value of one kind.
struct Leaf {
  std::function<void(const Json& given, const std::string& where)> read;  // throws InputError
  std::function<Json()> write;                                            // null if absent
  std::function<Json()> schema;                                           // its type
  bool has_default = false;    // what it holds, if the field is optional
  const char* unit = nullptr;  // told behind the help; null for a kind without
};

class Fields {
 public:
  using Visit = std::function<void(Fields&)>;
  using VisitItem = std::function<void(Fields&, std::size_t)>;

  Fields() = default;
  virtual ~Fields() = default;
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  void number(const Field& field, const Limits& limits, double& value);
  void number(const Field& field, const Limits& limits, std::optional<double>& value);
  void vector(const Field& field, const Limits& limits, Vec2& value);
  void vector(const Field& field, const Limits& limits, std::optional<Vec2>& value);
  // A list of at most `most` numbers.
  void numbers(const Field& field, const Limits& limits, std::size_t most,
               std::vector<double>& values);
  void integer(const Field& field, std::int64_t low, std::int64_t high, std::int64_t& value);
  void flag(const Field& field, bool& value);
  void text(const Field& field, std::string& value);
  // One of `words`, numbered from 0.
  void word(const Field& field, std::span<const std::string_view> words, int& value);
  // Null if absent.
  void json(const Field& field, const Shape& shape, Json& value);
  void object(const Field& field, const Visit& visit) { begin_optional(field, true, visit); }
  // One of the kinds of objects, by its word in `field`: `visit(Fields&)` visits its other fields.
  template <class... Kinds, class VisitKind>
  void one_of(const Field& field, std::variant<Kinds...>& value, VisitKind visit) {
    static constexpr std::array<std::string_view, sizeof...(Kinds)> kNames{Kinds::kName...};
    variant(field, kNames, static_cast<int>(value.index()), [&](Fields& f, int kind) {
      int k = 0;
      if (kind != static_cast<int>(value.index()))
        ((k++ == kind ? static_cast<void>(value = Kinds{}) : static_cast<void>(0)), ...);
      visit(f);
    });
  }
  // Exactly one of these optional fields, described before, must be given.
  virtual void exactly_one(const std::vector<std::string>& /*names*/) {}

  template <std::integral Int>
  void integer(const Field& field, std::int64_t low, std::int64_t high, Int& value) {
    auto wide = static_cast<std::int64_t>(value);
    integer(field, low, high, wide);
    value = static_cast<Int>(wide);
  }

  // An enum whose values are the indices of `words`.
  template <class Enum>
  void choice(const Field& field, std::span<const std::string_view> words, Enum& value) {
    int index = static_cast<int>(value);
    word(field, words, index);
    value = static_cast<Enum>(index);
  }

  // An object that may be absent; `describe(Fields&, T&)` visits its fields.
  template <class T, class Describe>
  void optional_object(const Field& field, std::optional<T>& value, Describe describe) {
    T present = value.value_or(T{});
    if (begin_optional(field, value.has_value(), [&](Fields& f) { describe(f, present); })) {
      value = std::move(present);
    }
  }

  // A list of at most `most` objects; `describe(Fields&, T&)` visits the fields of one.
  template <class T, class Describe>
  void list(const Field& field, std::size_t most, std::vector<T>& values, Describe describe) {
    items(
        field, most, values.size(), [&](std::size_t size) { values.resize(size); },
        [&](Fields& f, std::size_t i) { describe(f, values[i]); });
  }

  // The whole of the present object depends on the word in `field`: `visit(Fields&, index)`.
  virtual void variant(const Field& field, std::span<const std::string_view> words, int index,
                       const std::function<void(Fields&, int)>& visit) = 0;

  // Reports that a value is not admissible for a reason that a range cannot say. Only a reader has
  // values to judge; it throws InputError.
  virtual void refuse(const char* /*name*/, const std::string& /*problem*/,
                      const std::string& /*nearest*/ = {}) {}
  // Refuses `given`, from which a value of `key` follows, where that is not admissible.
  void require_within(const std::string& given, const std::string& key, const Limits& limits,
                      double value);
  // Whether values come from a file, so that what depends on them can be worked out after the visit.
  virtual bool reading() const { return false; }

 protected:
  virtual void leaf(const Field& field, const Leaf& leaf) = 0;

  // Returns whether the object is there.
  virtual bool begin_optional(const Field& field, bool present, const Visit& visit) = 0;
  virtual void items(const Field& field, std::size_t most, std::size_t size,
                     const std::function<void(std::size_t)>& resize, const VisitItem& visit) = 0;
};

// The name of a value's type with the value itself if it is short: `the text "big"`.
std::string described(const Json& value);

// A text as messages show it, cut short where it is long.
std::string shortened(const std::string& text, std::size_t most = 60);

// The range in words: "a number above 0 and at most 1e+06 [d]".
std::string described(const Limits& limits);

// Throws InputError if the list has more entries.
void refuse_longer_list(const Json& list, std::size_t most, const std::string& where);

// Shortest text that reads back as the same number.
std::string number_text(double value);

}  // namespace quicksand
