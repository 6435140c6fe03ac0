// How the structs of a checkpoint become CBOR: included by core/checkpoint*.cpp only.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace quicksand {

// One description of the format for both directions: archive(object, field...) either writes the
// fields or reads them.
class CheckpointWriter {
 public:
  explicit CheckpointWriter(nlohmann::json& json) : json_(json) {}

  template <class T>
  void value(const char* key, const T& x) {
    json_[key] = x;
  }
  // A value that earlier versions of the format do not have: who reads one of these keeps its own.
  template <class T>
  void added(const char* key, const T& x) {
    value(key, x);
  }
  template <class E>
  void word(const char* key, const E& x) {
    json_[key] = static_cast<int>(x);
  }
  // Plain arrays of doubles, Vec2, Vec3 or one-byte values, as raw bytes.
  template <class T>
  void array(const char* key, const std::vector<T>& items) {
    std::vector<std::uint8_t> bytes(items.size() * sizeof(T));
    if (!bytes.empty())
      std::memcpy(bytes.data(), static_cast<const void*>(items.data()), bytes.size());
    json_[key] = nlohmann::json::binary(std::move(bytes));
  }
  template <class F>
  void object(const char* key, F describe) {
    nlohmann::json inner = nlohmann::json::object();
    CheckpointWriter writer(inner);
    describe(writer);
    json_[key] = std::move(inner);
  }
  // Few structs; `describe(archive, item)` visits one.
  template <class T, class F>
  void list(const char* key, const std::vector<T>& items, F describe) {
    nlohmann::json entries = nlohmann::json::array();
    for (const T& item : items) {
      nlohmann::json entry = nlohmann::json::object();
      CheckpointWriter writer(entry);
      describe(writer, item);
      entries.push_back(std::move(entry));
    }
    json_[key] = std::move(entries);
  }
  template <class T>
  void optional(const char* key, const std::optional<T>& x) {
    json_[key] = x ? nlohmann::json(*x) : nlohmann::json(nullptr);
  }

 private:
  nlohmann::json& json_;
};

class CheckpointReader {
 public:
  explicit CheckpointReader(const nlohmann::json& json) : json_(json) {}

  template <class T>
  void value(const char* key, T& x) {
    json_.at(key).get_to(x);
  }
  template <class T>
  void added(const char* key, T& x) {
    if (json_.contains(key)) value(key, x);
  }
  template <class E>
  void word(const char* key, E& x) {
    const int number = json_.at(key).get<int>();
    x = static_cast<E>(number);
    if (static_cast<int>(x) != number)
      throw std::runtime_error(std::string(key) + " is no such word");
  }
  template <class T>
  void array(const char* key, std::vector<T>& items) {
    const auto& bytes = json_.at(key).get_binary();
    if (bytes.size() % sizeof(T) != 0) throw std::runtime_error(std::string(key) + " is cut short");
    items.resize(bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(static_cast<void*>(items.data()), bytes.data(), bytes.size());
  }
  template <class F>
  void object(const char* key, F describe) {
    CheckpointReader reader(json_.at(key));
    describe(reader);
  }
  template <class T, class F>
  void list(const char* key, std::vector<T>& items, F describe) {
    const nlohmann::json& entries = json_.at(key);
    if (!entries.is_array()) throw std::runtime_error(std::string(key) + " is no list");
    items.assign(entries.size(), T{});
    for (std::size_t k = 0; k < items.size(); ++k) {
      CheckpointReader reader(entries[k]);
      describe(reader, items[k]);
    }
  }
  template <class T>
  void optional(const char* key, std::optional<T>& x) {
    if (json_.at(key).is_null())
      x.reset();
    else
      x = json_.at(key).get<T>();
  }

 private:
  const nlohmann::json& json_;
};

}  // namespace quicksand
