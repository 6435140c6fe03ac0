#include "app/json/json_schema.h"

#include "app/json/json_reader.h"

namespace quicksand {

namespace {

Json number_schema(const Limits& limits) {
  Json schema = {{"type", "number"}};
  schema[limits.above ? "exclusiveMinimum" : "minimum"] = limits.low;
  schema["maximum"] = limits.high;
  return schema;
}

std::string help_with_unit(const Field& field, const Limits& limits) {
  return std::string(field.help) + " [" + limits.unit + "]";
}

}  // namespace

Json JsonSchema::take() {
  if (!alternatives_.empty()) return {{"type", "object"}, {"oneOf", alternatives_}};
  Json schema = {{"type", "object"}, {"additionalProperties", false}, {"properties", properties_}};
  if (!required_.empty()) schema["required"] = required_;
  if (!one_of_.empty()) schema["oneOf"] = one_of_;
  return schema;
}

Json& JsonSchema::add(const Field& field, Json schema) {
  if (field.presence == Presence::required) required_.push_back(field.name);
  if (!schema.contains("description")) schema["description"] = field.help;
  return properties_[field.name] = std::move(schema);
}

void JsonSchema::number(const Field& field, const Limits& limits, double& value) {
  Json schema = number_schema(limits);
  schema["description"] = help_with_unit(field, limits);
  if (field.presence == Presence::optional) schema["default"] = value / limits.scale;
  add(field, std::move(schema));
}

void JsonSchema::number(const Field& field, const Limits& limits,
                        std::optional<double>& /*value*/) {
  Json schema = number_schema(limits);
  schema["description"] = help_with_unit(field, limits);
  add(field, std::move(schema));
}

void JsonSchema::vector(const Field& field, const Limits& limits, Vec2& value) {
  std::optional<Vec2> absent;
  vector(field, limits, absent);
  if (field.presence == Presence::optional) {
    properties_[field.name]["default"] = {value.x() / limits.scale, value.y() / limits.scale};
  }
}

void JsonSchema::vector(const Field& field, const Limits& limits, std::optional<Vec2>& /*value*/) {
  add(field, {{"type", "array"},
              {"items", number_schema(limits)},
              {"minItems", 2},
              {"maxItems", 2},
              {"description", help_with_unit(field, limits)}});
}

void JsonSchema::numbers(const Field& field, const Limits& limits, std::size_t most,
                         std::vector<double>& /*values*/) {
  add(field, {{"type", "array"},
              {"items", number_schema(limits)},
              {"maxItems", most},
              {"description", help_with_unit(field, limits)}});
}

void JsonSchema::integer(const Field& field, std::int64_t low, std::int64_t high,
                         std::int64_t& value) {
  Json schema = {{"type", "integer"}, {"minimum", low}, {"maximum", high}};
  if (field.presence == Presence::optional) schema["default"] = value;
  add(field, std::move(schema));
}

void JsonSchema::flag(const Field& field, bool& value) {
  add(field, {{"type", "boolean"}, {"default", value}});
}

void JsonSchema::text(const Field& field, std::string& /*value*/) {
  add(field, {{"type", "string"}});
}

void JsonSchema::word(const Field& field, std::span<const std::string_view> words, int& value) {
  Json schema = {{"enum", Json::array()}};
  for (const std::string_view word : words) schema["enum"].push_back(std::string(word));
  if (field.presence == Presence::optional) {
    schema["default"] = std::string(words[static_cast<std::size_t>(value)]);
  }
  add(field, std::move(schema));
}

void JsonSchema::json(const Field& field, const Shape& shape, Json& /*value*/) {
  add(field, shape.schema());
}

void JsonSchema::object(const Field& field, const Visit& visit) {
  begin_optional(field, true, visit);
}

bool JsonSchema::begin_optional(const Field& field, bool /*present*/, const Visit& visit) {
  JsonSchema inner;
  visit(inner);
  add(field, inner.take());
  return false;
}

void JsonSchema::items(const Field& field, std::size_t most, std::size_t /*size*/,
                       const std::function<void(std::size_t)>& resize, const VisitItem& visit) {
  resize(1);  // an entry with its defaults
  JsonSchema inner;
  visit(inner, 0);
  add(field, {{"type", "array"}, {"maxItems", most}, {"items", inner.take()}});
  resize(0);
}

void JsonSchema::exactly_one(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    one_of_.push_back(Json{{"required", Json::array({name})}});
  }
}

void JsonSchema::variant(const Field& field, std::span<const std::string_view> words, int /*index*/,
                         const std::function<void(Fields&, int)>& visit) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    JsonSchema inner;
    inner.add({field.name, field.help, Presence::required}, {{"const", std::string(words[i])}});
    visit(inner, static_cast<int>(i));
    alternatives_.push_back(inner.take());
  }
}

}  // namespace quicksand
