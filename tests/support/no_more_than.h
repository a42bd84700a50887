// Files of this process cannot grow beyond some bytes: what a full disk is like.
#pragma once

#include <sys/resource.h>

#include <csignal>

struct NoMoreThan {
    explicit NoMoreThan(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~NoMoreThan() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_before_);
    }
    NoMoreThan(const NoMoreThan&) = delete;
    NoMoreThan& operator=(const NoMoreThan&) = delete;

  private:
    rlimit before_{};
    void (*handler_before_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};
