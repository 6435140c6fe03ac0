// Requests for the page and for files of the run: what they ask, whether they may, and the answer. The answers let the
// page load nothing from elsewhere and run nothing that is not in its files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "app/web/page_files.h"

struct lws;

namespace quicksand {

struct HttpRequest {
  bool is_get = false;   // GET or HEAD
  bool is_head = false;  // GET without the body
  std::string path;
  std::string host, origin;
  std::string token;  // of the address
  std::string cookies;
};
HttpRequest request_of(lws* wsi);

// Whom the server serves, and what.
struct Access {
  const std::string& token;
  const std::string& host;
  const std::filesystem::path& folder;
  int port;
};

// The status that refuses the request; 0 if it is admitted.
int refusal_of(const HttpRequest& request, const Access& access);

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  Payload body;
  std::filesystem::path file;  // sent instead of a body, if not empty
  bool head_only = false;      // without body or file
  std::string cookie;          // to be kept by the browser; empty: none
  std::size_t sent = 0;        // of the body [bytes]
};
HttpAnswer answer_to(const HttpRequest& request, const Access& access, const PageParts& parts);

// What the library expects from the handlers of a request and of room for more of the answer.
int begin_answer(lws* wsi, HttpAnswer& answer);
int go_on_answering(lws* wsi, HttpAnswer& answer);

}  // namespace quicksand
