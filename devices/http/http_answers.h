// Answers as HTTP/1.1, by cpp-httplib: a request's head is parsed, routed and answered by it in
// memory, so that neither a socket nor a file of the disk is ever within its reach.
//
// Every answer has the same headers: no script, style or connection but the page's own, nothing is
// kept by a browser, no other site may read it, nothing tells what serves it.
//
// Source    cpp-httplib 0.11 and 0.18: Server::process_request, which differs between them
// Left out  its own sockets: a queue of five connections, deadlines for each byte instead of the
//           whole, an end of the server where accept() fails once; its routes by regular
//           expressions, whose stack grows with a stranger's text; its compression
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "devices/http/request_bytes.h"

namespace tact {

struct HttpCall {
    std::string method;
    std::string path;  // as it was sent, percent signs and all, without what follows "?"
    std::string body;
    double handshake_s = 0.0;
};

struct HttpReply {
    int status = 404;
    std::string type{};  // of the text; "application/json"
    std::string text{};
};

class HttpAnswers {
  public:
    explicit HttpAnswers(std::function<HttpReply(const HttpCall&)> route);
    ~HttpAnswers();

    // From any thread.
    std::string answer(const RequestBytes& request, double handshake_s);

  private:
    class Library;
    std::unique_ptr<Library> library_;
};

}  // namespace tact
