#include "devices/http/http_answers.h"

#include <httplib.h>

#include <csignal>
#include <string>
#include <string_view>
#include <utility>

namespace tact {

namespace {

// Names of headers that no request can bring: its own are taken away before they are added.
constexpr const char* kHandshake = "handshake_us";
constexpr const char* kRefused = "refused";

const httplib::Headers& headers_of_all() {
    static const httplib::Headers all{
        {"Content-Security-Policy",
         "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
         "img-src 'self' data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cache-Control", "no-store"},
        {"Cross-Origin-Resource-Policy", "same-origin"}};
    return all;
}

// A head that is read from memory, and an answer that is written into it.
class MemoryStream final : public httplib::Stream {
  public:
    explicit MemoryStream(std::string_view head) : left_(head) {}

    bool is_readable() const override { return !left_.empty(); }
    bool is_writable() const override { return true; }
    ssize_t read(char* into, size_t size) override {
        const size_t count = left_.copy(into, size);
        left_.remove_prefix(count);
        return static_cast<ssize_t>(count);
    }
    ssize_t write(const char* from, size_t size) override {
        written.append(from, size);
        return static_cast<ssize_t>(size);
    }
    void get_remote_ip_and_port(std::string&, int& port) const override { port = 0; }
    void get_local_ip_and_port(std::string&, int& port) const override { port = 0; }
    socket_t socket() const override { return -1; }

    std::string written;

  private:
    std::string_view left_;
};

// The library ignores SIGPIPE for the whole process as it begins; other parts end by it, in a pipe.
class KeptPipeSignal {
  public:
    KeptPipeSignal() { sigaction(SIGPIPE, nullptr, &before_); }
    ~KeptPipeSignal() { sigaction(SIGPIPE, &before_, nullptr); }
    KeptPipeSignal(const KeptPipeSignal&) = delete;
    KeptPipeSignal& operator=(const KeptPipeSignal&) = delete;

  private:
    struct sigaction before_ {};
};

}  // namespace

class HttpAnswers::Library final : public httplib::Server {
  public:
    explicit Library(std::function<HttpReply(const HttpCall&)> route) : route_(std::move(route)) {
        set_default_headers(headers_of_all());
        set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& to) {
            reply(request, to);
            return HandlerResponse::Handled;
        });
    }

    bool process(httplib::Stream& stream, const std::function<void(httplib::Request&)>& set_up) {
        return process_by(*this, &Library::process_request, stream, set_up);
    }

  private:
    using SetUp = std::function<void(httplib::Request&)>;
    using Text = const std::string&;
    using Process011 = bool (httplib::Server::*)(httplib::Stream&, bool, bool&, const SetUp&);
    using Process018 = bool (httplib::Server::*)(httplib::Stream&, Text, int, Text, int, bool,
                                                 bool&, const SetUp&);

    static bool process_by(Library& self, Process011 process, httplib::Stream& stream,
                           const SetUp& set_up) {
        bool closed = false;
        return (self.*process)(stream, true, closed, set_up);
    }

    static bool process_by(Library& self, Process018 process, httplib::Stream& stream,
                           const SetUp& set_up) {
        bool closed = false;
        return (self.*process)(stream, {}, 0, {}, 0, true, closed, set_up);
    }

    void reply(const httplib::Request& request, httplib::Response& to) const {
        if (request.has_header(kRefused)) {
            to.status = std::stoi(request.get_header_value(kRefused));
            return;
        }
        const double handshake_us = std::stod(request.get_header_value(kHandshake));
        const HttpReply reply =
            route_({request.method, request.target.substr(0, request.target.find('?')),
                    request.body, 1e-6 * handshake_us});
        to.status = reply.status;
        if (!reply.text.empty()) to.set_content(reply.text, reply.type);
    }

    std::function<HttpReply(const HttpCall&)> route_;
};

HttpAnswers::HttpAnswers(std::function<HttpReply(const HttpCall&)> route) {
    const KeptPipeSignal kept;
    library_ = std::make_unique<Library>(std::move(route));
}

HttpAnswers::~HttpAnswers() = default;

std::string HttpAnswers::answer(const RequestBytes& request, double handshake_s) {
    const bool is_refused = request.refused != 0;
    MemoryStream stream(is_refused ? "GET / HTTP/1.1\r\n\r\n" : request.head());
    library_->process(stream, [&](httplib::Request& read) {
        read.headers.clear();
        if (is_refused) return read.set_header(kRefused, std::to_string(request.refused));
        read.body = request.body();
        read.set_header(kHandshake, std::to_string(1e6 * handshake_s));
    });
    return std::move(stream.written);
}

}  // namespace tact
