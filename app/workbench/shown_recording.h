#pragma once

#include "app/workbench/workbench.h"
#include "devices/formats/recording_file.h"

#include <QTimer>

#include <memory>

namespace halbench::app {

/// All of a recording at once in the panels, as if its device had been watched from its first row to its last
/// (resources/help/monitor.md, "Recordings"). It is read on the connection's thread; its samples go into the
/// history piece by piece, between the window's other work. Its time stands still: until a speed is chosen
/// nothing is played. Thread: GUI.
class ShownRecording : public QObject {
    Q_OBJECT

public:
    explicit ShownRecording(Workbench& bench);

    /// Leaves the device that is connected.
    void open(const QString& path);
    /// Ends reading, or putting into the history; what is there stays.
    void cancel();
    /// Another stream begins: what is in the history goes.
    void leave();

    bool isBusy() const { return !m_wanted.isEmpty() || m_filling.isActive(); }
    /// Of what it does: reading the file or, after it, showing the rows.
    double fraction() const { return m_fraction; }
    bool isReading() const { return !m_wanted.isEmpty(); }
    /// Of the one that is read or shown, or was.
    const QString& path() const { return m_path; }
    /// The one that is shown; none: the history is of something else.
    const std::shared_ptr<const devices::RecordedFile>& file() const { return m_file; }
    double length_s() const;
    /// Up to where it is in the history.
    double shown_s() const;

Q_SIGNALS:
    void changed();
    void began();                      ///< its first rows follow
    void ended();                      ///< all of it is there, or it was cancelled
    void doubted(const QString& text); ///< it is not as it was recorded; the log says it too

private:
    void onState();
    void begin(std::shared_ptr<const devices::RecordedFile> file);
    void sayDoubts();
    void fill();
    SampleBlock nextPiece() const;
    void forget();

    Workbench& m_bench;
    QString m_path;
    QString m_wanted; ///< the address that is being opened; empty: none
    std::shared_ptr<const devices::RecordedFile> m_file;
    std::size_t m_nextRow = 0;
    double m_fraction = 0.0;
    QTimer m_filling;
};

} // namespace halbench::app
