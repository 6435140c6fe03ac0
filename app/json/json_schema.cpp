#include "app/json/json_schema.h"

namespace quicksand {

namespace {

class JsonSchema : public Fields {
 public:
  // The schema of the object that was visited.
  Json take() {
    if (!alternatives_.empty()) return {{"type", "object"}, {"oneOf", alternatives_}};
    Json schema = {
        {"type", "object"}, {"additionalProperties", false}, {"properties", properties_}};
    if (!required_.empty()) schema["required"] = required_;
    if (!one_of_.empty()) schema["oneOf"] = one_of_;
    return schema;
  }

  void exactly_one(const std::vector<std::string>& names) override {
    for (const std::string& name : names) {
      one_of_.push_back(Json{{"required", Json::array({name})}});
    }
  }

  void variant(const Field& field, std::span<const std::string_view> words, int /*index*/,
               const std::function<void(Fields&, int)>& visit) override {
    for (std::size_t i = 0; i < words.size(); ++i) {
      JsonSchema inner;
      inner.add({field.name, field.help, Presence::required}, {{"const", std::string(words[i])}});
      visit(inner, static_cast<int>(i));
      alternatives_.push_back(inner.take());
    }
  }

 protected:
  void leaf(const Field& field, const Leaf& leaf) override {
    Json schema = leaf.schema();
    if (leaf.unit != nullptr)
      schema["description"] = std::string(field.help) + " [" + leaf.unit + "]";
    if (leaf.has_default && field.presence == Presence::optional) schema["default"] = leaf.write();
    add(field, std::move(schema));
  }

  bool begin_optional(const Field& field, bool /*present*/, const Visit& visit) override {
    add(field, object_schema(visit));
    return false;
  }

  void items(const Field& field, std::size_t most, std::size_t /*size*/,
             const std::function<void(std::size_t)>& resize, const VisitItem& visit) override {
    resize(1);  // an entry with its defaults
    Json entry = object_schema([&](Fields& f) { visit(f, 0); });
    add(field, {{"type", "array"}, {"maxItems", most}, {"items", std::move(entry)}});
    resize(0);
  }

 private:
  void add(const Field& field, Json schema) {
    if (field.presence == Presence::required) required_.push_back(field.name);
    if (!schema.contains("description")) schema["description"] = field.help;
    properties_[field.name] = std::move(schema);
  }

  Json properties_ = Json::object();
  Json required_ = Json::array();
  Json one_of_ = Json::array();
  Json alternatives_ = Json::array();  // of a variant, which then is all there is
};

}  // namespace

Json object_schema(const Fields::Visit& describe) {
  JsonSchema fields;
  describe(fields);
  return fields.take();
}

Json file_schema(const char* title, const std::string& description, const Fields::Visit& describe) {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  if (!description.empty()) schema["description"] = description;
  schema.update(object_schema(describe));
  return schema;
}

}  // namespace quicksand
