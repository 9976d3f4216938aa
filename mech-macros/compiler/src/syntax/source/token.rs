//! The tokens of a text one after the other, brackets among them.

use proc_macro2::{Delimiter, Group, LexError, Span, TokenStream, TokenTree};

/// A word, a number, a mark or a bracket.
#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) text: String,
    pub(super) kind: TokenKind,
}

/// The kinds of tokens. Brackets have the place of the whole group.
#[derive(Clone, Debug)]
pub(super) enum TokenKind {
    Open(Group),
    Close(Delimiter, Span),
    Single(TokenTree),
}

impl Token {
    pub(super) fn is_word(&self) -> bool {
        matches!(&self.kind, TokenKind::Single(TokenTree::Ident(_) | TokenTree::Literal(_)))
    }

    /// Where it stands.
    pub(super) fn span(&self) -> Span {
        match &self.kind {
            TokenKind::Open(group) => group.span_open(),
            TokenKind::Close(_, span) => *span,
            TokenKind::Single(tree) => tree.span(),
        }
    }
}

/// Reads a piece of a text.
pub(super) fn read(text: &str) -> Result<Vec<Token>, LexError> {
    Ok(flat(text.parse()?))
}

/// The tokens of a stream, with those in brackets. Nothing here calls itself: the stack does not hold what stands in many brackets.
pub(super) fn flat(stream: TokenStream) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut waiting = vec![(stream.into_iter(), None)];
    while let Some((trees, _)) = waiting.last_mut() {
        match trees.next() {
            Some(TokenTree::Group(group)) => {
                let (delimiter, end) = (group.delimiter(), group.span_close());
                tokens.push(Token {
                    text: brackets(delimiter)[0].to_owned(),
                    kind: TokenKind::Open(empty(&group)),
                });
                waiting.push((group.stream().into_iter(), Some((delimiter, end))));
            }
            Some(tree) => {
                tokens.push(Token { text: tree.to_string(), kind: TokenKind::Single(tree) });
            }
            None => {
                let ended = waiting.pop().and_then(|(_, end)| end);
                tokens.extend(ended.map(|(delimiter, end)| Token {
                    text: brackets(delimiter)[1].to_owned(),
                    kind: TokenKind::Close(delimiter, end),
                }));
            }
        }
    }
    tokens
}

/// The brackets of a group without what is in them.
fn empty(group: &Group) -> Group {
    let mut shell = Group::new(group.delimiter(), TokenStream::new());
    shell.set_span(group.span());
    shell
}

fn brackets(delimiter: Delimiter) -> [&'static str; 2] {
    match delimiter {
        Delimiter::Parenthesis => ["(", ")"],
        Delimiter::Brace => ["{", "}"],
        Delimiter::Bracket => ["[", "]"],
        Delimiter::None => ["", ""],
    }
}

/// The stream of these tokens; none if their brackets do not match.
pub(super) fn stream(tokens: &[Token]) -> Option<TokenStream> {
    let mut open: Vec<(&Group, Vec<TokenTree>)> = Vec::new();
    let mut trees = Vec::new();
    for token in tokens {
        match &token.kind {
            TokenKind::Single(tree) => trees.push(tree.clone()),
            TokenKind::Open(shell) => open.push((shell, std::mem::take(&mut trees))),
            TokenKind::Close(delimiter, _) => {
                let (shell, before) = open.pop()?;
                if shell.delimiter() != *delimiter {
                    return None;
                }
                let inside = std::mem::replace(&mut trees, before);
                let mut group = Group::new(*delimiter, inside.into_iter().collect());
                group.set_span(shell.span());
                trees.push(TokenTree::Group(group));
            }
        }
    }
    open.is_empty().then(|| trees.into_iter().collect())
}
