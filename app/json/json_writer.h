// Writes the fields of an object as JSON with every default explicit.
#pragma once

#include "app/json/fields.h"
#include "app/json/json_text.h"

namespace quicksand {

class JsonWriter : public Fields {
 public:
  Json take() { return std::move(object_); }

  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override;

 protected:
  void leaf(const Field& field, const Leaf& leaf) override;
  bool begin_optional(const Field& field, bool present, const Visit& visit) override;
  void items(const Field& field, std::size_t most, std::size_t size,
             const std::function<void(std::size_t)>& resize, const VisitItem& visit) override;

 private:
  Json object_ = Json::object();
};

// The fields of a struct, by `describe(Fields&, T&)`.
template <class T, class Describe>
Json written_fields(T value, Describe describe) {  // a copy: a visit may change what it visits
  JsonWriter writer;
  describe(writer, value);
  return writer.take();
}

}  // namespace quicksand
