#include "app/workbench/signals/loop_capture.h"

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

constexpr int Period_ms = 100;
constexpr double Pieces = 64.0; ///< in which a board's capture is read, about

/// A board keeps a level in single precision.
bool isSame(const ParameterValue& one, const ParameterValue& other) {
    return one.name == other.name && static_cast<float>(one.value) == static_cast<float>(other.value);
}

bool isSame(const std::vector<ParameterValue>& one, const std::vector<ParameterValue>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const auto& a, const auto& b) { return isSame(a, b); });
}

} // namespace

LoopCapture::LoopCapture(DeviceSession& session, QObject* parent)
    : QObject(parent), m_session(session), m_living(&session) {
    renew();
    m_timer.setInterval(Period_ms);
    connect(&m_timer, &QTimer::timeout, this, &LoopCapture::work);
    connect(&m_session, &DeviceSession::stateChanged, this, &LoopCapture::onSession);
    connect(&m_session, &DeviceSession::procedureChanged, this, &LoopCapture::work);
}

LoopCapture::~LoopCapture() {
    if (!m_living) {
        return;
    }
    delete m_disconnectTask;
    m_session.request([kept = m_kept](devices::Device& device) { return putBack(device, *kept); },
                      [](const Result<void>&) {});
}

/// For another device.
void LoopCapture::renew() {
    delete m_disconnectTask;
    m_kept = std::make_shared<Kept>();
    m_disconnectTask = new DisconnectTask(
        m_session, [kept = m_kept](devices::Device& device) { (void)putBack(device, *kept); });
}

void LoopCapture::start(const CaptureConfig& config) {
    m_config = config;
    again();
}

void LoopCapture::again() {
    m_isWanted = true;
    m_isBegun = false;
    m_pieces = 0;
    m_timer.start();
    setState(State::Begins);
    work();
}

void LoopCapture::stop() {
    m_isWanted = false;
    m_isBegun = false;
    setState(State::Off);
    work();
}

void LoopCapture::setRecordingWritten(bool isWritten) {
    if (std::exchange(m_isRecordingWritten, isWritten) != isWritten) {
        work();
    }
}

/// A board that is looked for may come back as it was left. The connection's thread has ended once there is
/// no device any more.
void LoopCapture::onSession() {
    if (m_session.state() == SessionState::Connected) {
        work();
        return;
    }
    ++m_asked;
    m_isAsking = false;
    m_isBegun = false;
    if (m_session.state() == SessionState::Disconnected) {
        if (m_kept->before) {
            m_session.message(MessageLevel::Warning, tr("capture"),
                              tr("Device lost before its capture settings were restored. Unless it was "
                                 "restarted, the settings of the last capture are still active"));
        }
        renew();
    }
    if (m_isWanted && m_state != State::Done && m_state != State::Failed) {
        setState(State::Begins);
    }
}

/// One order at a time; what it answers leads to the next.
void LoopCapture::work() {
    if (m_isAsking || m_session.state() != SessionState::Connected) {
        return;
    }
    if (!m_session.procedure().isEmpty()) {
        if (m_isWanted && m_state != State::Done && m_state != State::Failed) {
            setState(State::Held);
        }
        return;
    }
    if (!m_isWanted) {
        end();
    } else if (m_state == State::Done || m_state == State::Failed) {
        m_timer.stop();
    } else if (!m_isBegun) {
        beginCapture();
    } else if (m_state == State::Reading && !m_isRecordingWritten) {
        read();
    } else {
        look();
    }
}

/// What answers an order that does not count any more leads to what is wanted now.
template <typename Function, typename Then>
void LoopCapture::ask(Function function, Then then) {
    m_isAsking = true;
    m_session.request(std::move(function),
                      [this, self = QPointer<LoopCapture>(this), asked = m_asked, then](auto answer) {
                          if (!self || asked != m_asked) {
                              return;
                          }
                          m_isAsking = false;
                          if (m_isWanted && m_isBegun && m_session.procedure().isEmpty()) {
                              then(std::move(answer));
                          } else {
                              work();
                          }
                      });
}

void LoopCapture::beginCapture() {
    const auto values = captureSetUp(m_session.catalogue(), m_config);
    if (!values) {
        fail(values.error());
        return;
    }
    setState(State::Begins);
    m_isBegun = true;
    ask([values = *values, kept = m_kept](devices::Device& device) { return begin(device, *kept, values); },
        [this](const Result<void>& done) { done ? look() : fail(done.error()); });
}

/// What is on the board now is put back later, unless it is what an earlier capture set there.
Result<void> LoopCapture::begin(devices::Device& device, Kept& kept, const SetUp& values) {
    auto now = captureSetUpBefore(device, values);
    if (!now) {
        return failure(now.error());
    }
    if (!kept.before || !isSame(*now, kept.ours)) {
        kept.before = *std::move(now);
    }
    kept.ours = values;
    return startCapture(device, values);
}

/// Once: what is put back is forgotten, unless the device was lost over it. What somebody else set meanwhile
/// stays as it is; a board that was restarted captures nothing and has nothing of ours.
Result<void> LoopCapture::putBack(devices::Device& device, Kept& kept) {
    if (!kept.before) {
        return {};
    }
    const auto now = captureSetUpBefore(device, *kept.before);
    const auto state = now ? readCaptureState(device) : Result<CaptureState>(failure(now.error()));
    Result<void> done = state ? Result<void>() : failure(state.error());
    if (state && (isSame(*now, kept.ours) || *state != CaptureState::Idle)) {
        SetUp owed;
        for (std::size_t i = 0; i < now->size(); ++i) {
            if (isSame((*now)[i], kept.ours[i])) {
                owed.push_back((*kept.before)[i]);
            }
        }
        done = endCapture(device, owed);
    }
    if (done || done.error().code != ErrorCode::DeviceLost) {
        kept.before.reset();
    }
    return done;
}

void LoopCapture::end() {
    m_timer.stop();
    m_isAsking = true;
    m_session.request([kept = m_kept](devices::Device& device) { return putBack(device, *kept); },
                      [this, self = QPointer<LoopCapture>(this), asked = m_asked](const Result<void>&) {
                          if (self && asked == m_asked) { // a board that cannot be asked says so elsewhere
                              m_isAsking = false;
                              if (m_isWanted) {
                                  work();
                              }
                          }
                      });
}

void LoopCapture::look() {
    ask([](devices::Device& device) { return readCaptureState(device); },
        [this](const Result<CaptureState>& state) { state ? saw(*state) : fail(state.error()); });
}

void LoopCapture::saw(CaptureState state) {
    switch (state) {
    case CaptureState::Idle:
        fail({ErrorCode::Protocol, "the device's capture was ended by another program",
              "make sure that no other program uses it, then re-arm the trigger"});
        break;
    case CaptureState::Filling:
        setState(State::Filling);
        break;
    case CaptureState::Waiting:
        setState(State::Waiting);
        break;
    case CaptureState::Running:
        setState(State::Running);
        break;
    case CaptureState::Full:
        setState(m_isRecordingWritten ? State::Full : State::Reading);
        if (!m_isRecordingWritten) {
            read();
        }
        break;
    }
}

void LoopCapture::read() {
    using Piece = std::shared_ptr<Recording>; // changes threads as it is
    ask(
        [](devices::Device& device) -> Result<Piece> {
            Result<Recording> piece = device.readCapture();
            return piece ? Result<Piece>(std::make_shared<Recording>(*std::move(piece)))
                         : failure(piece.error());
        },
        [this](const Result<Piece>& piece) {
            took(piece ? Result<Recording>(std::move(**piece)) : failure(piece.error()));
        });
}

void LoopCapture::took(Result<Recording> piece) {
    constexpr int MostPieces = 4096; // one row each
    ++m_pieces;
    if (piece && piece->rows() == 0 && m_pieces < MostPieces) {
        Q_EMIT changed();
        look(); // whether it is still the capture that was full
        return;
    }
    Result<Recording> whole = checkCapture(std::move(piece), m_config);
    if (whole && whole->rows() == 0) {
        whole = failure(ErrorCode::Protocol, "the device sent no data of its completed capture",
                        "another program may be using its capture; try again");
    }
    if (!whole) {
        fail(whole.error());
        return;
    }
    m_recording = *std::move(whole);
    setState(State::Done);
    Q_EMIT captured();
}

double LoopCapture::fraction() const {
    return m_state == State::Reading ? std::min(1.0, m_pieces / Pieces) : 0.0;
}

void LoopCapture::fail(const Error& error) {
    m_error = error;
    setState(State::Failed);
}

void LoopCapture::setState(State state) {
    if (std::exchange(m_state, state) != state) {
        Q_EMIT changed();
    }
}

} // namespace halbench::app
