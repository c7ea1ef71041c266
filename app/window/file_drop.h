#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace halbench::app {

/// A file dropped on a window: a recording or table (.csv, .txt, .tsv, .mf4) or a project (.toml), by its
/// name. Several files at once, and other kinds, are refused with the kinds that are taken.
class FileDrop : public QObject {
    Q_OBJECT

public:
    explicit FileDrop(QWidget& window);

Q_SIGNALS:
    void recordingDropped(const QString& path);
    void projectDropped(const QString& path);
    void refused(const QString& text, const QString& hint);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take(const QStringList& paths);
};

} // namespace halbench::app
