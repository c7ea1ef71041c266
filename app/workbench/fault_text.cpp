#include "app/workbench/fault_text.h"

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
          QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Release the stop, then arm, to move again.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Coil temperature above its limit"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Let the coils cool. Use less current or add pauses.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Current command above the limit"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Use a smaller set-point or amplitude.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Speed above its limit"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Use less current or a slower reference, or widen the speed window.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Position outside its window"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Use a smaller motion, or widen the excursion window.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "The measured angle jumped"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Turn more slowly. Check for magnets or iron near the Hall sensors.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Hall sensor out of range"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Check the sensors and their connector, then calibrate the Hall sensors.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Controller output is not a number"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Write proven gains.")},
    Words{QT_TRANSLATE_NOOP("halbench::app::FaultWords", "Output converter of a coil not responding"),
          QT_TRANSLATE_NOOP("halbench::app::FaultWords",
                            "Check the board's cables and supply, then release the stop.")},
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
