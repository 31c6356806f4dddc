# Completion of canvoy for bash: verbs, options, buses, nodes, objects, states. The command itself knows them.
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
