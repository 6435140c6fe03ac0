// Makes the JSON Schema (draft 07, which editors know) of what a JsonReader accepts.
#pragma once

#include "app/json/fields.h"
#include "app/json/json_text.h"

namespace quicksand {

// The whole schema of a kind of file: `describe(Fields&)` visits the fields of one with its defaults.
Json file_schema(const char* title, const std::string& description, const Fields::Visit& describe);

class JsonSchema : public Fields {
 public:
  // The schema of the object that was visited.
  Json take();

  void exactly_one(const std::vector<std::string>& names) override;
  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override;

 protected:
  void leaf(const Field& field, const Leaf& leaf) override;
  bool begin_optional(const Field& field, bool present, const Visit& visit) override;
  void items(const Field& field, std::size_t most, std::size_t size,
             const std::function<void(std::size_t)>& resize, const VisitItem& visit) override;

 private:
  void add(const Field& field, Json schema);

  Json properties_ = Json::object();
  Json required_ = Json::array();
  Json one_of_ = Json::array();
  Json alternatives_ = Json::array();  // of a variant, which then is all there is
};

}  // namespace quicksand
