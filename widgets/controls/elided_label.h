#pragma once

#include <QLabel>

namespace halbench::widgets {

/// A label of one line that may be narrower than its words: what does not fit is left out at the end and
/// stands in the tooltip.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(int leastCharacters, QWidget* parent = nullptr);

    void setWords(const QString& words);
    const QString& words() const { return m_words; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    void setLeastCharacters(int characters);
    /// What minimumSizeHint() is for so many letters of longer words: a row that keeps it does not move with
    /// the words.
    int leastWidth_px(int characters) const;

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QSize sizeFor(const QString& text) const;
    void fit();

    int m_leastCharacters;
    QString m_words;
};

} // namespace halbench::widgets
