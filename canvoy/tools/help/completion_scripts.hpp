// Scripts for bash, zsh and fish to complete canvoy. scripts/completion has them as files for
// packages (tests/cli/help_test.py compares them).
#pragma once

namespace canvoy::tools {

inline constexpr const char* bash_completion =
    R"script(# Completion of canvoy for bash: verbs, options, buses, nodes, objects, states. The command itself knows them.
#
#     source scripts/completion/canvoy.bash

_canvoy() {
  local line=${COMP_LINE:0:COMP_POINT} words current prefix
  read -ra words <<<"$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  current=${words[-1]}
  mapfile -t COMPREPLY < <("${words[0]}" complete -- "${words[@]:1}" 2>/dev/null)
  # To bash, what stands before a colon is a word of its own.
  if [[ $current == *:* && $COMP_WORDBREAKS == *:* ]]; then
    prefix=${current%"${current##*:}"}
    COMPREPLY=("${COMPREPLY[@]#"$prefix"}")
  fi
}
complete -o bashdefault -o default -F _canvoy canvoy
)script";

inline constexpr const char* zsh_completion = R"script(#compdef canvoy
# Completion of canvoy for zsh: verbs, options, buses, nodes, objects, states. The command itself knows them.

local -a found
found=("${(@f)$("${words[1]}" complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
if [[ -n "${found[1]}" ]]; then
  compadd -M 'm:{a-zA-Z_-}={A-Za-z-_}' -- "${found[@]}"
else
  _files
fi
)script";

inline constexpr const char* fish_completion =
    R"script(# Completion of canvoy for fish: verbs, options, buses, nodes, objects, states. The command itself knows them; where it knows
# nothing, a file may be meant.

function __canvoy_complete
  set -l words (commandline --tokenize --cut-at-cursor --current-process) (commandline --current-token --cut-at-cursor)
  set -l found ($words[1] complete -- $words[2..-1] 2>/dev/null)
  if test (count $found) -gt 0
    printf '%s\n' $found
  else
    __fish_complete_path $words[-1]
  end
end

complete --command canvoy --no-files --arguments '(__canvoy_complete)'
)script";

}  // namespace canvoy::tools
