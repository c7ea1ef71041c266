#pragma once

#include "app/documents/frequency_file.h"
#include "app/figures/tuning_figures.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"

#include <QPushButton>

#include <optional>

namespace halbench::widgets {
struct Message;
}

namespace halbench::app {

class TuneSession;

/// Measured frequency response in the open loop of the proposed gains, and the button that opens it or takes
/// it away. Hidden without a file chooser. Thread: GUI.
class MeasuredOverlay : public QPushButton {
    Q_OBJECT
public:
    /// `session` outlives it.
    explicit MeasuredOverlay(const TuneSession& session, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser);
    /// Overlays a response; one that is of another loop is refused.
    void use(const MeasuredPlant& plant);
    void forget();
    /// With the gains of the sketch; nothing at another sampling rate.
    std::optional<MeasuredLoop> loop() const;

Q_SIGNALS:
    void changed();
    void used(const halbench::widgets::Message& message); ///< before changed()
    void failed(const halbench::Error& error);

protected:
    void changeEvent(QEvent* event) override;

private:
    void choose();
    void refreshTexts();

    const TuneSession& m_session;
    FileChooser m_chooser;
    FileQueue m_files;
    std::optional<MeasuredPlant> m_plant;
};

} // namespace halbench::app
