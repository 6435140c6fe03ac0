#include "app/json/json_writer.h"

namespace quicksand {

void JsonWriter::number(const Field& field, const Limits& limits, double& value) {
  object_[field.name] = value / limits.scale;
}

void JsonWriter::number(const Field& field, const Limits& limits, std::optional<double>& value) {
  if (value) number(field, limits, *value);
}

void JsonWriter::vector(const Field& field, const Limits& limits, Vec2& value) {
  object_[field.name] = {value.x() / limits.scale, value.y() / limits.scale};
}

void JsonWriter::vector(const Field& field, const Limits& limits, std::optional<Vec2>& value) {
  if (value) vector(field, limits, *value);
}

void JsonWriter::numbers(const Field& field, const Limits& limits, std::size_t /*most*/,
                         std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(value / limits.scale);
  object_[field.name] = std::move(list);
}

void JsonWriter::integer(const Field& field, std::int64_t /*low*/, std::int64_t /*high*/,
                         std::int64_t& value) {
  object_[field.name] = value;
}

void JsonWriter::flag(const Field& field, bool& value) { object_[field.name] = value; }

void JsonWriter::text(const Field& field, std::string& value) {
  // An absent text and an empty one are the same.
  if (!value.empty()) object_[field.name] = value;
}

void JsonWriter::word(const Field& field, std::span<const std::string_view> words, int& value) {
  object_[field.name] = std::string(words[static_cast<std::size_t>(value)]);
}

void JsonWriter::json(const Field& field, const Shape& /*shape*/, Json& value) {
  if (!value.is_null()) object_[field.name] = value;
}

void JsonWriter::object(const Field& field, const Visit& visit) {
  begin_optional(field, true, visit);
}

bool JsonWriter::begin_optional(const Field& field, bool present, const Visit& visit) {
  if (!present) return false;
  JsonWriter inner;
  visit(inner);
  object_[field.name] = inner.take();
  return true;
}

void JsonWriter::items(const Field& field, std::size_t /*most*/, std::size_t size,
                       const std::function<void(std::size_t)>& /*resize*/, const VisitItem& visit) {
  Json list = Json::array();
  for (std::size_t i = 0; i < size; ++i) {
    JsonWriter inner;
    visit(inner, i);
    list.push_back(inner.take());
  }
  object_[field.name] = std::move(list);
}

void JsonWriter::variant(const Field& field, std::span<const std::string_view> words, int index,
                         const std::function<void(Fields&, int)>& visit) {
  word(field, words, index);
  visit(*this, index);
}

}  // namespace quicksand
