#include "app/batch/interrupt.h"

#include <unistd.h>

#include <csignal>

namespace halbench::app {

namespace {

// A signal handler can reach nothing but an object of static storage.
std::atomic<int> receivedSignal{0};

extern "C" void onSignal(int number) {
    if (receivedSignal.exchange(number) != 0) {
        _exit(128 + number);
    }
}

extern "C" void onAbort(int) {
    _exit(5);
}

} // namespace

const std::atomic<int>& catchSignals() {
    struct sigaction action = {};
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    action.sa_handler = onAbort;
    sigaction(SIGABRT, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    return receivedSignal;
}

} // namespace halbench::app
