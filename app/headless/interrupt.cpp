#include "app/headless/interrupt.h"

#include <unistd.h>

#include <csignal>

namespace halbench::app {

namespace {

// A signal handler can reach nothing but an object of static storage.
std::atomic<int> receivedSignal{0};
std::atomic<int> receivedWishes{0};

/// The first signal is the one that counts. A terminal that closes says so several times (the system, the
/// shell, the session's manager): a hang-up is no impatient user, nor is the first signal that comes with it.
extern "C" void onSignal(int number) {
    int none = 0;
    receivedSignal.compare_exchange_strong(none, number);
    if (number != SIGHUP && receivedWishes.fetch_add(1) != 0) {
        _exit(128 + number);
    }
}

extern "C" void onAbort(int) {
    _exit(5);
}

void handle(int number, void (*handler)(int)) {
    struct sigaction action = {};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    for (const int other : {SIGINT, SIGTERM, SIGQUIT, SIGHUP}) {
        sigaddset(&action.sa_mask, other); // of two that come at once, the first is handled first
    }
    sigaction(number, &action, nullptr);
}

bool isIgnored(int number) {
    struct sigaction action = {};
    return sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

const std::atomic<int>& catchSignals() {
    for (const int number : {SIGINT, SIGTERM, SIGQUIT}) {
        handle(number, onSignal);
    }
    if (!isIgnored(SIGHUP)) {
        handle(SIGHUP, onSignal);
    }
    handle(SIGABRT, onAbort);
    std::signal(SIGPIPE, SIG_IGN);
    return receivedSignal;
}

} // namespace halbench::app
