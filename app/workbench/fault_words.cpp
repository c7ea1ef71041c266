#include "app/workbench/fault_words.h"

#include "widgets/language/phrasebook.h"

#include <QCoreApplication>

#include <array>

namespace halbench::app {

namespace {

constexpr char Context[] = "halbench::app::FaultWords";

struct Words {
    const char* what;
    const char* remedy;
};

/// By the board's fault code (devices/firmware/control/hb_safety.h); 0 is a stop without a fault.
constexpr std::array Table = {
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Stopped"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Nothing moves until the stop is released and the device armed again.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "A coil is hotter than its limit"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Let the coils cool down; drive with less current or with pauses.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "More current was asked for than the limit allows"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Use a smaller set-point or amplitude.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "It turned faster than its window allows"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Use less current or a slower reference, or widen the speed window on purpose.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "It moved farther than its window allows"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Use a smaller motion, or widen the excursion window on purpose.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "The measured angle jumped"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Turn more slowly; look for magnets or iron near the Hall sensors.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "A Hall sensor does not see the rotor"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Look at sensors and plug, and calibrate the Hall sensors.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "The controller computed a number that is none"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Write gains that are known to work.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "A converter that drives a coil does not answer"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Look at the board's cables and supply, then release the stop.")},
};

/// The board's words say that it stopped; beside "Stopped" only the reason is said.
struct Reason {
    const char* said;
    const char* words;
};

} // namespace

QString stopReason(const devices::DeviceState& board, const QString& asker) {
    constexpr std::array Reasons = {
        Reason{"stopped by command", QT_TRANSLATE_NOOP("halbench::app::FaultWords", "by command")},
        Reason{"stopped by watchdog", QT_TRANSLATE_NOOP("halbench::app::FaultWords", "by the watchdog")}};
    for (const Reason& reason : Reasons) {
        if (board.faultText == reason.said) {
            const bool isAsked = &reason == &Reasons.front();
            return isAsked && !asker.isEmpty() ? asker : QCoreApplication::translate(Context, reason.words);
        }
    }
    return widgets::inWords(board.faultText);
}

FaultWords faultWords(const devices::DeviceState& board, const QString& asker) {
    if (board.fault == 0 && !board.isStopLatched) {
        return {};
    }
    const QString said = widgets::inWords(board.faultText);
    const auto say = [](const char* text) { return QCoreApplication::translate(Context, text); };
    if (board.fault >= Table.size()) {
        return {said, say(Table[0].remedy)};
    }
    const Words& words = Table[board.fault];
    if (board.fault == 0 && !said.isEmpty()) {
        return {
            say(QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Stopped: %1")).arg(stopReason(board, asker)),
            say(words.remedy)};
    }
    return {say(words.what), say(words.remedy)};
}

} // namespace halbench::app
