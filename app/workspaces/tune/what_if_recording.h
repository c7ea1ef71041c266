#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/workbench.h"

#include <QObject>
#include <QString>

#include <utility>

namespace halbench::app {

class TuneMessages;
class TuneSession;
class WhatIfPage;

/// Recording of the what-if page: chosen in a file dialog, with the file of its gains where they are not
/// recorded, or refused in place. Thread: GUI.
class WhatIfRecording : public QObject {
    Q_OBJECT
public:
    /// All of them outlive it.
    WhatIfRecording(Workbench& bench, const TuneSession& session, TuneMessages& messages, WhatIfPage& page,
                    QObject* parent = nullptr);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }
    void use(const QString& path);
    /// Asks for the gains of a recording that does not have them; the answer to the message that says so.
    void chooseGains();

Q_SIGNALS:
    void used(); ///< the page shows it

private:
    void choose();
    void take(const QString& path);
    void refuse(const Error& error);

    Workbench& m_bench;
    const TuneSession& m_session;
    TuneMessages& m_messages;
    WhatIfPage& m_page;
    FileChooser m_chooser;
    QString m_pending; ///< until it is read, or its gains are chosen
};

} // namespace halbench::app
