// A value, or one sentence saying why it is missing (std::expected is C++23).
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace tact {

// A sentence a user can act on: it names the file, line or field, and what was expected.
struct Error {
    std::string message;
};

// For functions that either do their work or say why not.
struct Done {};

template <class Value>
class [[nodiscard]] Expected {
  public:
    Expected(Value value) : content_(std::move(value)) {}  // NOLINT(google-explicit-constructor)
    Expected(Error error) : content_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

    explicit operator bool() const { return std::holds_alternative<Value>(content_); }

    Value& operator*() & { return checked(); }
    const Value& operator*() const& { return const_cast<Expected*>(this)->checked(); }
    Value&& operator*() && { return std::move(checked()); }
    Value* operator->() { return &checked(); }
    const Value* operator->() const { return &**this; }

    const Error& error() const {
        assert(!*this && "error() of an Expected that holds a value");
        return std::get<Error>(content_);
    }

  private:
    Value& checked() {
        assert(*this && "value of an Expected that holds an error");
        return std::get<Value>(content_);
    }

    std::variant<Value, Error> content_;
};

// What work threw, as the sentence a person reads: programs end with words, windows continue.

// The exception being handled: call it in a catch.
Error thrown_error();

}  // namespace tact
