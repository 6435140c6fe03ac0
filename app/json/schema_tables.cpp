#include "app/json/schema_tables.h"

#include <algorithm>
#include <utility>

#include "app/json/json_reader.h"

namespace quicksand {

namespace {

std::string code(const std::string& text) { return "`" + text + "`"; }

// "a, b or c".
std::string alternatives(const Json& words, const char* between) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? between : ", ";
    text += code(words[i].get<std::string>());
  }
  return text;
}

std::string bound(const Json& number) {
  return number.is_number_integer() ? std::to_string(number.get<std::int64_t>())
                                    : number_text(number.get<double>());
}

std::string range(const Json& number) {
  const auto low = number.find("exclusiveMinimum");
  return low != number.end() ? "above " + bound(*low) + ", at most " + bound(number["maximum"])
                             : bound(number["minimum"]) + " to " + bound(number["maximum"]);
}

std::string list_values(const Json& schema) {
  const std::string most =
      schema.contains("maxItems") ? " of at most " + bound(schema["maxItems"]) : std::string();
  const Json items = schema.value("items", Json::object());
  if (!items.contains("maximum"))
    return "list" + most + (items.contains("properties") ? " objects" : "");
  if (schema.contains("minItems")) return "[x, y], each " + range(items);
  return "list" + most + " numbers, each " + range(items);
}

// What a value may be.
std::string values(const Json& schema) {
  if (schema.contains("enum")) return alternatives(schema["enum"], " or ");
  if (schema.contains("const")) return code(schema["const"].get<std::string>());
  if (!schema.contains("type")) return "any value";
  if (schema["type"].is_array()) return words_of_types(schema["type"]);
  const std::string type = schema["type"];
  if (type == "array") return list_values(schema);
  if (type == "string") return "text";
  if (type == "boolean") return "true or false";
  if (type == "object") return "object";
  return (type == "integer" ? "integer, " : "") + range(schema);
}

// The meaning, and the unit that stands behind it in brackets; none for pure numbers.
std::pair<std::string, std::string> meaning_and_unit(const Json& schema) {
  std::string help = schema.value("description", std::string());
  const std::size_t open = help.rfind(" [");
  if (!help.ends_with("]") || open == std::string::npos || values(schema) == "text")
    return {help, ""};
  const std::string unit = help.substr(open + 2, help.size() - open - 3);
  return {help.substr(0, open), unit == "1" ? "" : " " + unit};
}

// A cell must not end where its text has a bar.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

bool requires_key(const Json& schema, const std::string& key) {
  const auto required = schema.find("required");
  return required != schema.end() && std::ranges::find(*required, Json(key)) != required->end();
}

std::string default_of(const Json& schema, const Json& field, const std::string& key) {
  if (requires_key(schema, key)) return "required";
  if (!field.contains("default")) return "";
  const Json& value = field["default"];
  if (value.is_array()) return "[" + bound(value[0]) + ", " + bound(value[1]) + "]";
  if (value.is_string()) return code(value);
  return value.is_number() ? bound(value) : value.dump();
}

// Rows of the objects below `prefix`; `kind`: of a value that may be of several, the one that they apply to.
class Rows {
 public:
  explicit Rows(const std::set<std::string>& left_out) : left_out_(left_out) {}

  void add(const Json& schema, const std::string& prefix, const std::string& kind) {
    for (const auto& [key, field] : schema["properties"].items()) {
      if (left_out_.contains(prefix + key) || (!kind.empty() && field.contains("const"))) continue;
      const auto [meaning, unit] = meaning_and_unit(field);
      add(prefix + key, values(field) + unit, default_of(schema, field, key), kind + meaning);
      if (field.contains("properties")) add(field, prefix + key + ".", kind);
      if (field.contains("items") && field["items"].contains("properties"))
        add(field["items"], prefix + key + "[].", kind);
      if (field.contains("oneOf")) add_kinds(field["oneOf"], prefix + key + ".");
    }
  }

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& key, const std::string& values, const std::string& usual,
           const std::string& meaning) {
    text_ +=
        "| " + code(key) + " | " + cell(values) + " | " + usual + " | " + cell(meaning) + " |\n";
  }

  void add_kinds(const Json& kinds, const std::string& prefix) {
    Json names = Json::array();
    for (const Json& kind : kinds) names.push_back(kind["properties"]["type"]["const"]);
    const Json& type = kinds[0]["properties"]["type"];
    add(prefix + "type", alternatives(names, " or "), "required", type["description"]);
    for (const Json& kind : kinds)
      add(kind, prefix, code(kind["properties"]["type"]["const"]) + ": ");
  }

  const std::set<std::string>& left_out_;
  std::string text_;
};

}  // namespace

std::string words_of_types(const Json& types) {
  std::string text;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (i > 0) text += i + 1 == types.size() ? " or " : ", ";
    const std::string type = types[i];
    text += type == "string"    ? "text"
            : type == "array"   ? "list"
            : type == "boolean" ? "true, false"
                                : type;
  }
  return text;
}

std::string key_table(const Json& schema, const std::set<std::string>& left_out) {
  Rows rows(left_out);
  rows.add(schema, "", "");
  if (rows.text().empty()) return {};
  std::string table = "| key | values | default | meaning |\n|---|---|---|---|\n" + rows.text();
  if (!schema.contains("oneOf")) return table;
  Json keys = Json::array();
  for (const Json& one : schema["oneOf"]) keys.push_back(one["required"][0]);
  return table + "\nExactly one of " + alternatives(keys, " and ") + " must be given.\n";
}

}  // namespace quicksand
