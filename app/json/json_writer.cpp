#include "app/json/json_writer.h"

namespace quicksand {

void JsonWriter::leaf(const Field& field, const Leaf& leaf) {
  Json value = leaf.write();
  if (!value.is_null()) object_[field.name] = std::move(value);
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
