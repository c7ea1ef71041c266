#pragma once

#include <QString>
#include <QWidget>

#include <vector>

class QLabel;
class QVBoxLayout;

namespace halbench::widgets {

/// One remark with what to do about it.
struct Remark {
    QString message;
    QString hint;
};

enum class VerdictLevel { Good, Doubtful, Refused };

/// A verdict in words with a symbol, and below it every remark with its remedy.
class VerdictView : public QWidget {
    Q_OBJECT
public:
    explicit VerdictView(QWidget* parent = nullptr);

    /// `title` says what is judged in one line, e.g. "Good: nothing speaks against the model".
    void setVerdict(VerdictLevel level, const QString& title, const std::vector<Remark>& remarks);
    QString text() const; ///< all of it, one line each
    /// The remarks stand there and not below the title: where something else needs that place more.
    void moveRemarks(QVBoxLayout& place);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void keepLinesWhole();

    VerdictLevel m_level = VerdictLevel::Good;
    QString m_titleText;
    std::vector<Remark> m_remarks;
    QLabel* m_symbol = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_words = nullptr;
};

} // namespace halbench::widgets
