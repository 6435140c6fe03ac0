#include "app/json/json_writer.h"

namespace quicksand {

namespace {

class JsonWriter : public Fields {
 public:
  Json take() { return std::move(object_); }

  void variant(const Field& field, std::span<const std::string_view> words, int index,
               const std::function<void(Fields&, int)>& visit) override {
    word(field, words, index);
    visit(*this, index);
  }

 protected:
  void leaf(const Field& field, const Leaf& leaf) override {
    Json value = leaf.write();
    if (!value.is_null()) object_[field.name] = std::move(value);
  }

  bool begin_optional(const Field& field, bool present, const Visit& visit) override {
    if (present) object_[field.name] = written_object(visit);
    return present;
  }

  void items(const Field& field, std::size_t /*most*/, std::size_t size,
             const std::function<void(std::size_t)>& /*resize*/, const VisitItem& visit) override {
    Json& list = object_[field.name] = Json::array();
    for (std::size_t i = 0; i < size; ++i)
      list.push_back(written_object([&](Fields& f) { visit(f, i); }));
  }

 private:
  Json object_ = Json::object();
};

}  // namespace

Json written_object(const Fields::Visit& describe) {
  JsonWriter writer;
  describe(writer);
  return writer.take();
}

}  // namespace quicksand
