# Completion of canvoy for fish: verbs, options, buses, nodes, objects, states. The command itself knows them; where it knows
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
