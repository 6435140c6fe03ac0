// What clients may say.
#include "app/serve/client_message.h"

#include <gtest/gtest.h>

#include "app/commands/command_table.h"
#include "core/base/errors.h"

namespace quicksand::test {
namespace {

std::string refusal_of(const std::string& text) {
  Json id;
  try {
    read_message(text, id);
  } catch (const InputError& error) {
    return error.where() + ": " + error.what();
  }
  return {};
}

TEST(ClientMessage, IsACommandOrAQuestionWithAnId) {
  Json id;
  const ClientMessage command = read_message(R"({"command": "run", "steps": 3, "id": 7})", id);
  EXPECT_EQ(command.command, (Json{{"command", "run"}, {"steps", 3}}));
  EXPECT_EQ(id, 7);
  EXPECT_TRUE(command.question.is_null());
  const ClientMessage question = read_message(R"({"ask": "body", "at": [1, 2]})", id);
  EXPECT_TRUE(question.command.is_null());
  EXPECT_EQ(question.question["ask"], "body");
  EXPECT_TRUE(id.is_null());
  EXPECT_THROW(read_message(R"({"command": "run", "steps": -1, "id": 8})", id), InputError);
  EXPECT_EQ(id, 8) << "of a refused message, too";
}

TEST(ClientMessage, EachCommandIsAdmittedOrRefusedByItsName) {
  int admitted = 0;
  for (const SessionCommand& command : session_commands()) {
    const std::string refusal = refusal_of(std::string(command.example));
    if (refusal.empty()) {
      ++admitted;
    } else {
      EXPECT_NE(refusal.find("not available to browsers"), std::string::npos) << refusal;
      EXPECT_TRUE(command.group == "Panel" || command.group == "Session" ||
                  command.name == "open" || command.name == "expect_image")
          << command.name;
    }
  }
  EXPECT_GT(admitted, 20);
}

TEST(ClientMessage, NoFileBeyondTheFolderIsNamed) {
  for (const char* text :
       {R"({"command": "load", "scene": "/etc/passwd"})",
        R"({"command": "load", "scene": "../x.json"})",
        R"({"command": "load", "scene": "chain", "set": {"start_from": "/root/state.cbor"}})",
        R"({"command": "load", "scene": {"start_from": "state.cbor"}})",
        R"({"command": "set", "path": "start_from", "value": "/etc/passwd"})",
        R"({"command": "save", "file": "../state.cbor"})",
        R"({"command": "save", "file": "/tmp/state.cbor"})",
        R"({"command": "restore", "file": "/tmp/state.cbor"})",
        R"({"command": "restore", "file": "a/../../b"})",
        R"({"command": "snapshot", "file": "../x.png"})",
        R"({"command": "record", "on": true, "folder": ".."})",
        R"({"command": "measure", "folder": "/tmp"})",
        R"({"command": "export", "format": "csv", "out": "/tmp/x"})"})
    EXPECT_NE(refusal_of(text).find("run's folder"), std::string::npos)
        << text << ": " << refusal_of(text);
}

TEST(ClientMessage, WhatIsNoMessageSaysWhy) {
  for (const char* text :
       {"", "{", "[]", "1", "null", R"({})", R"({"command": 1})", R"({"command": "fly"})",
        R"({"command": "run", "steps": -1})", R"({"ask": 3})",
        R"({"command": "pause", "id": {"a": 1}})", R"({"command": "pause", "x": 1})"})
    EXPECT_FALSE(refusal_of(text).empty()) << text;
  EXPECT_FALSE(refusal_of(std::string(200, '[')).empty()) << "too deep";
}

}  // namespace
}  // namespace quicksand::test
