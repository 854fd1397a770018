# The picture that `kyvadlo fit --plot` draws of the church of examples/fits.
system('kyvadlo fit examples/fits/foucault.nml examples/fits/foucault.csv --output fitted.txt --plot fitted.svg')
page = 'svg'
load 'fitted.gp'
