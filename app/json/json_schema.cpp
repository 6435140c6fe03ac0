#include "app/json/json_schema.h"

namespace quicksand {

Json file_schema(const char* title, const std::string& description, const Fields::Visit& describe) {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  if (!description.empty()) schema["description"] = description;
  JsonSchema fields;
  describe(fields);
  schema.update(fields.take());
  return schema;
}

Json JsonSchema::take() {
  if (!alternatives_.empty()) return {{"type", "object"}, {"oneOf", alternatives_}};
  Json schema = {{"type", "object"}, {"additionalProperties", false}, {"properties", properties_}};
  if (!required_.empty()) schema["required"] = required_;
  if (!one_of_.empty()) schema["oneOf"] = one_of_;
  return schema;
}

void JsonSchema::add(const Field& field, Json schema) {
  if (field.presence == Presence::required) required_.push_back(field.name);
  if (!schema.contains("description")) schema["description"] = field.help;
  properties_[field.name] = std::move(schema);
}

void JsonSchema::leaf(const Field& field, const Leaf& leaf) {
  Json schema = leaf.schema();
  if (leaf.unit != nullptr)
    schema["description"] = std::string(field.help) + " [" + leaf.unit + "]";
  if (leaf.has_default && field.presence == Presence::optional) schema["default"] = leaf.write();
  add(field, std::move(schema));
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
