# SPDX-License-Identifier: BSD-3-Clause
# Completion in bash. Both programs say themselves what may follow (`--complete WORD...`): "text<TAB>meaning" a line.
_rouleau() {
  local rest=$COMP_LINE piece line text files words=() plain=()
  # bash cuts words at = and :, too; here lambda=5 and --format=csv are whole.
  for piece in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
    if [[ ${#words[@]} -eq 0 || $rest == [[:space:]]* ]]; then words+=("$piece"); else words[-1]+=$piece; fi
    rest=${rest#"${rest%%[![:space:]]*}"}
    rest=${rest#"$piece"}
  done
  for piece in "${words[@]}"; do
    piece=${piece//[\'\"\\]/}
    plain+=("${piece/#\~\//$HOME/}")
  done
  # What bash has cut off stays on the line: candidates go without it. A word that began with a quote was not cut.
  local quote=${words[-1]%"${words[-1]#[\'\"]}"} cut=${plain[-1]%"${plain[-1]##*[=:]}"}
  [[ -n $quote || $COMP_WORDBREAKS != *=* ]] && cut=

  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      '<files>'*) files=-f ;;
      '<directories>'*) files=${files:--d} ;;
      *)
        text=${line%%$'\t'*}
        [[ $text == *= ]] && compopt -o nospace
        text=${text#"$cut"}
        [[ -z $quote && $text == *[[:space:]#]* ]] && printf -v text %q "$text"
        COMPREPLY+=("$text") ;;
    esac
  done < <("${plain[0]}" --complete "${plain[@]:1}" 2>/dev/null)
  if [[ -n $files ]]; then
    compopt -o filenames
    while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen "$files" -- "${plain[-1]#"$cut"}")
  fi
}
complete -F _rouleau rouleau rouleau-solver
