// Makes the JSON Schema (draft 07, which editors know) of what a JsonReader accepts.
#pragma once

#include "app/json/fields.h"
#include "app/json/json_text.h"

namespace quicksand {

class JsonSchema : public Fields {
 public:
  // The schema of the object that was visited.
  Json take();

  void number(const Field& field, const Limits& limits, double& value) override;
  void number(const Field& field, const Limits& limits, std::optional<double>& value) override;
  void vector(const Field& field, const Limits& limits, Vec2& value) override;
  void vector(const Field& field, const Limits& limits, std::optional<Vec2>& value) override;
  void numbers(const Field& field, const Limits& limits, std::size_t most,
               std::vector<double>& values) override;
  void integer(const Field& field, std::int64_t low, std::int64_t high,
               std::int64_t& value) override;
  void flag(const Field& field, bool& value) override;
  void text(const Field& field, std::string& value) override;
  void word(const Field& field, std::span<const std::string_view> words, int& value) override;
  void json(const Field& field, const Shape& shape, Json& value) override;
  void object(const Field& field, const Visit& visit) override;
  void exactly_one(const std::vector<std::string>& names) override;
  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override;
  void refuse(const char* /*name*/, const std::string& /*problem*/) override {}

 protected:
  bool begin_optional(const Field& field, bool present, const Visit& visit) override;
  void items(const Field& field, std::size_t most, std::size_t size,
             const std::function<void(std::size_t)>& resize, const VisitItem& visit) override;

 private:
  Json& add(const Field& field, Json schema);

  Json properties_ = Json::object();
  Json required_ = Json::array();
  Json one_of_ = Json::array();
  Json alternatives_ = Json::array();  // of a variant, which then is all there is
};

}  // namespace quicksand
