#pragma once

#include "app/documents/model_file.h"
#include "app/workbench/workbench.h"
#include "control/design/crossover_design.h"

#include <QObject>

#include <optional>

namespace halbench::app {

class GainSettings;
class LoopSliders;
class LoopView;
class TuneSession;

/// State of an interactive loop-shaping drag: crossover, phase margin or a pole of the loop is moved with the
/// sliders or the handles of the picture, and the gains follow. Nothing goes to a device. Thread: GUI.
class LoopShaping : public QObject {
    Q_OBJECT
public:
    /// All of them outlive it.
    LoopShaping(Workbench& bench, TuneSession& session, GainSettings& settings, LoopView& view,
                QObject* parent = nullptr);

    /// Drops the drag: other gains were chosen, and a step that still waits does not come after them.
    void drop();
    /// Takes the move that waited for the picture of the one before.
    void takeWaiting();
    /// Sets the sliders to the loop that is drawn.
    void showLoop();

Q_SIGNALS:
    void moved();    ///< the settings have other gains
    void released(); ///< the drag ended; the session is not told yet

private:
    enum class Kind { Crossover, Margin, Gain };
    struct Drag {
        LoopLaw law;                              ///< at its begin
        std::optional<control::CrossoverAim> aim; ///< wanted now; nothing: the loop does not cross
        double factor = 1.0;                      ///< wanted on all gains of `law`
        QString what;                             ///< name of the step in the history
        Kind kind = Kind::Crossover;
        bool isWaiting = false; ///< until the picture of the last move is there
        bool isHeld = false;    ///< until it is released; else a step of the keyboard
    };

    template <typename Controls>
    void connectControls(const Controls& controls);
    bool start(bool isHeld);
    void move(Kind kind, double value);
    bool aim(Kind kind, double value);
    void take();
    void release();
    Result<LoopLaw> movedLaw();
    Result<control::PidGains> scaledGains(const control::PositionPlant& plant);
    Result<control::PidGains> crossingGains(const control::PositionPlant& plant);

    Workbench& m_bench;
    TuneSession& m_session;
    GainSettings& m_settings;
    LoopSliders& m_sliders;
    std::optional<Drag> m_drag;
};

} // namespace halbench::app
